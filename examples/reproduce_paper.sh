#!/usr/bin/env bash
# Reproduces the paper (Xu, Zhang, Ying, Yu: Simulation study on cavity growth in ductile metal materials under dynamic
# loading, 2013): all runs, figures 1 to 9 and the table of claims, in the paper's scheme and beside it in the default
# scheme on refined meshes.
#
#   examples/reproduce_paper.sh                  the full set, an hour or two of one core
#   examples/reproduce_paper.sh --coarse         all figures on coarser meshes, within five minutes on two cores
#   examples/reproduce_paper.sh --figures-only   draws and tests what has been run before
#   --out DIR       where it all goes; default: build/paper of this repository
#   --jobs N        runs at a time; default: as many as there are cores
#   --runs-only     no figures and no table
#   --only WORD     only the runs whose names begin with WORD
#   --again         make finished runs anew, as after a change of the library
#
# Runs that are finished are kept, so an interrupted reproduction goes on where it was. Figures are written to
# DIR/SET/figures, the table to DIR/SET/claims.md; SET is full or coarse. Installs what is missing with apt. Exit code: 0
# done, 2 packages are missing or the command line is wrong, 1 anything else.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
build=$root/build/cavity-release
. "$here/packages.sh"

needed=(g++ cmake ninja-build libeigen3-dev libcli11-dev nlohmann-json3-dev python3 python3-numpy python3-pil
  python3-matplotlib python3-vtk9 xvfb xauth)

out=$root/build/paper arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    --out) [ $# -gt 1 ] || { echo "reproduce_paper: --out has no value" >&2; exit 2; }
      out=$2; shift ;;
    --jobs | --only) [ $# -gt 1 ] || { echo "reproduce_paper: $1 has no value" >&2; exit 2; }
      arguments+=("$1" "$2"); shift ;;
    --coarse | --figures-only | --runs-only | --again) arguments+=("$1") ;;
    --help | -h) sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
    *) echo "reproduce_paper: '$1' is not an option; --help lists them" >&2; exit 2 ;;
  esac
  shift
done

demand_packages "${needed[@]}"

echo "building (some minutes the first time)"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMOTE_NATIVE=ON -DMOTE_BUILD_TESTS=OFF \
  -DMOTE_BUILD_BENCHMARKS=OFF >"$log" 2>&1 && cmake --build "$build" --target cavity paper_study >"$log" 2>&1 ||
  { cat "$log" >&2; exit 1; }

/usr/bin/python3 "$here/paper/driver.py" --programs "$build" --out "$out" "${arguments[@]+"${arguments[@]}"}"
