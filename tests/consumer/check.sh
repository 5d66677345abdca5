#!/usr/bin/env bash
# check.sh ROUTE SOURCE_DIR BUILD_DIR COMPILER [FLAGS...]: builds and runs tests/consumer/ROUTE in a scratch directory.
set -eu
route=$1 source=$2 build=$3 compiler=$4
compile=("${@:4}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

if [ "$route" = find_package ]; then
  cmake --install "$build" --prefix "$scratch/prefix" >/dev/null
  arguments=(-DCMAKE_PREFIX_PATH="$scratch/prefix")
else
  arguments=(-DMOTE_SOURCE="$source")
fi
cmake -G Ninja -S "$source/tests/consumer/$route" -B "$scratch/build" -DCMAKE_CXX_COMPILER="$compiler" "${arguments[@]}"
cmake --build "$scratch/build"
"$scratch/build/consumer"

# `|| true`: grep finds nothing, as it should
macros=$("${compile[@]}" -dM -E "$source/tests/consumer/$route/main.cpp" | grep -i '^#define mote' || true)
if [ -n "$macros" ]; then
  echo "mote leaks macros into its user:"
  echo "$macros"
  exit 1
fi
