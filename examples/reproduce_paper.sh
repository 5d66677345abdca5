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

needed=(g++ cmake ninja-build libeigen3-dev libcli11-dev nlohmann-json3-dev python3 python3-numpy python3-pil
  python3-matplotlib python3-vtk9 xvfb xauth)

# Leaves those of the given packages that are not installed in `missing`.
find_missing() {
  missing=()
  local package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
}

# Tries to install the packages; leaves those that are still not there in `missing`.
install() {
  find_missing "$@"
  [ ${#missing[@]} -eq 0 ] && return
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    sudo -n true 2>/dev/null || return 0
    as_root=(sudo -n)
  fi
  echo "installing ${missing[*]}"
  "${as_root[@]}" apt-get update -qq >/dev/null 2>&1 || true
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" \
    >/dev/null 2>&1 || true
  find_missing "$@"
}

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

install "${needed[@]}"
if [ ${#missing[@]} -gt 0 ]; then
  echo "missing packages that could not be installed (root or sudo, and apt, are needed): ${missing[*]}" >&2
  exit 2
fi

echo "building (some minutes the first time)"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMOTE_NATIVE=ON -DMOTE_BUILD_TESTS=OFF \
  -DMOTE_BUILD_BENCHMARKS=OFF >"$log" 2>&1 && cmake --build "$build" --target cavity paper_study >"$log" 2>&1 ||
  { cat "$log" >&2; exit 1; }

/usr/bin/python3 "$here/paper/driver.py" --programs "$build" --out "$out" "${arguments[@]+"${arguments[@]}"}"
