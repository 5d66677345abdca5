#!/usr/bin/env bash
# Builds the library's tests, studies and examples with g++, and tests and small examples with clang++-16, warnings as
# errors; runs the tests of both.
#
#   tests/run_tests.sh [--gcc-only] [--label LABEL] [ctest arguments...]
#
#   --gcc-only      leave clang out
#   --label LABEL   run the tests of this label only, and build the slow ones and the benchmarks too; without it, all but
#                   those of the label slow
#
# Installs what is missing with apt. The last line is "N passed, N failed" over both compilers; a build that fails counts
# as one failure. Exit code: 0 all passed, 1 something failed, 2 packages are missing.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. examples/packages.sh

presets=(gcc-release clang-release)
packages=(g++ cmake ninja-build libeigen3-dev catch2 librapidcheck-dev libbenchmark-dev libcli11-dev nlohmann-json3-dev
          clang-16)
selection=(-LE '^slow$')
slow=OFF quick=ON clang=yes
while [ $# -gt 0 ]; do
  case $1 in
    --gcc-only) clang=no ;;
    --label)
      selection=(-L "^${2:?--label needs a label}\$"); slow=ON quick=OFF
      [ "$2" != slow ] || clang=no  # slow are the studies alone, and g++ alone builds them
      shift ;;
    -h | --help) sed -n '2,/^set/{/^#/p}' "${BASH_SOURCE[0]}"; exit 0 ;;
    *) break ;;
  esac
  shift
done
[ $clang = yes ] || { presets=(gcc-release); unset 'packages[-1]'; }

passed=0
failed=0

# run PRESET [ctest arguments...]
run() {
  local preset=$1 log=build/$1/ctest.log
  shift
  echo "== $preset: building"
  # studies and the cavity program take minutes to build; they say more of the schemes than of the compiler. Unless slow
  # tests run, the examples are compiled quickly.
  local measure=OFF targets=(all)
  [ "$preset" = gcc-release ] && measure=ON targets+=(all_verify_interface_header_sets)
  if ! cmake --preset "$preset" -DMOTE_BUILD_BENCHMARKS=$slow -DMOTE_BUILD_SLOW_STUDIES=$slow \
    -DMOTE_BUILD_STUDIES=$measure -DMOTE_BUILD_CAVITY=$measure -DMOTE_QUICK_EXAMPLES=$quick \
    >build/configure.log 2>&1; then
    cat build/configure.log
    failed=$((failed + 1))
    return
  fi
  # -k 0: build what can be built, so that one broken file does not hide the other tests
  if ! cmake --build "build/$preset" -j2 --target "${targets[@]}" -- -k 0 --quiet; then
    echo "== $preset: the build failed"
    failed=$((failed + 1))
  fi
  echo "== $preset: testing"
  ctest --test-dir "build/$preset" -j2 --output-on-failure --no-tests=error "${selection[@]}" "$@" | tee "$log"
  local summary='^[0-9]+% tests passed, ([0-9]+) tests failed out of ([0-9]+)$'
  if [[ $(grep -E "$summary" "$log") =~ $summary ]]; then
    failed=$((failed + BASH_REMATCH[1]))
    passed=$((passed + BASH_REMATCH[2] - BASH_REMATCH[1]))
  else
    echo "== $preset: no test ran"
    failed=$((failed + 1))
  fi
}

demand_packages "${packages[@]}"
mkdir -p build
for preset in "${presets[@]}"; do
  run "$preset" "$@"
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
