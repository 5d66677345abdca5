#!/usr/bin/env bash
# Builds and runs all benchmarks, writes the tables of docs/performance.md and draws docs/pictures/performance_*.png.
#
#   bench/run_all.sh              everything: five minutes of compiling, five of measuring
#   bench/run_all.sh NAME...      only these: phases step scaling skips memory compile_time; the others' last results
#                                 stay in the tables. `bench/run_all.sh none` only writes tables and pictures anew.
#
# Results stay in build/bench/*.json and compile_time.csv. Leave the machine alone meanwhile: ratios are taken in turns
# and survive a neighbour, absolute times do not.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
results=$root/build/bench
build=$root/build/gcc-release
mkdir -p "$results"
cd "$root"
[ $# -gt 0 ] || set -- phases step scaling skips memory compile_time

programs=()
for name in "$@"; do
  case $name in
    none | compile_time) ;;
    *) programs+=("$name") ;;
  esac
done
if [ ${#programs[@]} -gt 0 ]; then
  cmake --preset gcc-release -DMOTE_BUILD_BENCHMARKS=ON >"$results/configure.log"
  cmake --build "$build" -j1 --target "${programs[@]/#/mote_bench_}" >"$results/build.log"
fi
for name in "${programs[@]}"; do
  echo "== $name"
  "$build/bench/mote_bench_$name" --benchmark_out="$results/$name.new" --benchmark_out_format=json \
    --benchmark_counters_tabular=true
  mv "$results/$name.new" "$results/$name.json"  # only a run that came to its end counts
done
case " $* " in *" compile_time "*) echo "== compile_time" && bench/compile_time.sh ;; esac
/usr/bin/python3 bench/tables.py
/usr/bin/python3 bench/plot.py
