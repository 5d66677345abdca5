#!/usr/bin/env bash
# Builds the cavity program, runs it, makes pictures, and compares the result with the paper.
#
#   examples/run_cavity.sh                 the preset quick, into cavity-out
#   examples/run_cavity.sh ARGUMENTS...    passes the arguments on to cavity (cavity --help lists them;
#                                          without --preset it runs the preset accurate)
#
# Installs what is missing with apt. Exit code: 0 done (also if the plotting packages cannot be had), 2 packages are
# missing or the command line is wrong, 1 anything else.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
build=$root/build/cavity-release
. "$here/packages.sh"

needed=(g++ cmake ninja-build libeigen3-dev libcli11-dev nlohmann-json3-dev)
plotting=(python3 python3-numpy python3-matplotlib python3-vtk9 xvfb xauth)

# Of history.csv at a time (ns): "single low grid" for a word, min or max; nothing if the run has no such sample.
measured() {
  local columns=vz_min_m_s,vz_low_m_s,vz_min_grid_m_s
  [ "$3" = max ] && columns=vz_max_m_s,vz_high_m_s,vz_max_grid_m_s
  awk -F, -v time="$2" -v names="$columns" '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; split(names, name, ","); next }
    ($1 - time) ^ 2 < 1e-6 { printf "%10.0f %10.0f %10.0f", $at[name[1]], $at[name[2]], $at[name[3]]; exit }' "$1"
}

compare() {
  echo
  echo "v_z in m/s                  paper     single  12.5 um^3       grid   (extremes of particles, 12.5 um^3, nodes)"
  local time which paper numbers
  while read -r time which paper; do
    numbers=$(measured "$1/history.csv" "$time" "$which")
    printf '%s at %3s ns            %9s %s\n' "$which" "$time" "$paper" "${numbers:-   (the run has no sample there)}"
  done <<<"2 min -230
3 min -300
7.2 max 430" | sed 's/^min/smallest/; s/^max/largest /'
  grep -q '"speed_m_s": 100.0' "$1/summary.json" || echo "(the paper's numbers are for a launch at 100 m/s)"
}

demand_packages "${needed[@]}"
pictures=yes
install_packages "${plotting[@]}"
[ ${#missing[@]} -gt 0 ] && pictures="not made: ${missing[*]} could not be installed"

echo "building (a minute or two the first time)"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMOTE_NATIVE=ON -DMOTE_BUILD_TESTS=OFF \
  -DMOTE_BUILD_BENCHMARKS=OFF >"$log" 2>&1 && cmake --build "$build" --target cavity >"$log" 2>&1 ||
  { cat "$log" >&2; exit 1; }

[ $# -eq 0 ] && set -- --preset quick --out cavity-out --overwrite
out=cavity-out only_talk=
for ((i = 1; i <= $#; ++i)); do
  case ${!i} in
    --out) next=$((i + 1)); out=${!next:-} ;;
    --out=*) out=${!i#--out=} ;;
    --dry-run | --help | -h | --version) only_talk=yes ;;
  esac
done
"$build/examples/cavity/cavity" "$@" || exit $?
[ -n "$only_talk" ] && exit 0

if [ "$pictures" = yes ]; then
  echo "making pictures"
  /usr/bin/python3 "$here/cavity/plot.py" "$out" >"$log" || pictures="not all made; the reasons are above"
fi
compare "$out"
echo
if [ "$pictures" != yes ]; then echo "pictures: $pictures"; fi
echo "open:"
for file in "$out"/pictures/*.png "$out/history.csv" "$out/axis.csv" "$out/summary.json" "$out"/frames/*.pvd; do
  if [ -e "$file" ]; then echo "  $file"; fi
done
