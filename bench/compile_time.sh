#!/usr/bin/env bash
# How long does the compiler take?
#
#   bench/compile_time.sh [CSV]     by default build/bench/compile_time.csv
#
# Seconds of user time to compile examples/first_program.cpp at -O2, medians of five rounds in which the compilers take
# turns (the bar is 10 s); and for each header alone with g++ -fsyntax-only, once.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
csv=${1:-$root/build/bench/compile_time.csv}
mkdir -p "$(dirname "$csv")"
flags=(-std=c++20 -I"$root/include" -isystem /usr/include/eigen3)
compilers=()
for compiler in g++ clang++-16; do
  command -v $compiler >/dev/null && compilers+=($compiler)
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Prints the user time of a command, s.
TIMEFORMAT=%U
user_time() { { time "$@" >/dev/null; } 2>&1 | tail -1; }
median() { sort -n | awk '{v[NR] = $1} END {print v[int((NR + 1) / 2)]}'; }

for _ in 1 2 3 4 5; do
  for compiler in "${compilers[@]}"; do
    user_time "$compiler" "${flags[@]}" -O2 -c "$root/examples/first_program.cpp" -o "$scratch/out.o" \
      >>"$scratch/$compiler"
  done
done

echo "what,compiler,seconds" >"$csv"
for compiler in "${compilers[@]}"; do
  echo "first_program.cpp -O2,$compiler,$(median <"$scratch/$compiler")" | tee -a "$csv"
done
cd "$root/include"
find mote -name '*.hpp' | sort | while read -r header; do
  echo "#include <$header>" >"$scratch/one.cpp"
  echo "$header,g++ -fsyntax-only,$(user_time g++ "${flags[@]}" -fsyntax-only "$scratch/one.cpp")" >>"$csv"
done
