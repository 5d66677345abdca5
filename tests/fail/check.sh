#!/usr/bin/env bash
# check.sh FILE COMPILER [FLAGS...]: FILE must compile as it is; with -DMOTE_FAIL it must not, and the compiler must say
# the sentence of FILE's first line, "// expect: sentence".
set -u
file=$1
shift
sentence=$(sed -n '1s|^// expect: ||p' "$file")
if [ -z "$sentence" ]; then
  echo "$file: the first line must be '// expect: sentence'"
  exit 1
fi

if ! LC_ALL=C "$@" -fsyntax-only "$file"; then
  echo "$file: the correct twin does not compile"
  exit 1
fi
if output=$(LC_ALL=C "$@" -fsyntax-only -DMOTE_FAIL "$file" 2>&1); then
  echo "$file: compiles, although it must not"
  exit 1
fi
line=$(grep -nF -m1 -- "$sentence" <<<"$output" | cut -d: -f1)
if [ -z "$line" ]; then
  echo "$file: the compiler does not say \"$sentence\". It says:"
  echo "$output"
  exit 1
fi
echo "the sentence is on line $line of $(wc -l <<<"$output") of the compiler's output"
