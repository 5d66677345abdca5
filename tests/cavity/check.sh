#!/usr/bin/env bash
# check.sh CAVITY SOURCE SCRATCH: exercises the cavity program; SCRATCH is a directory of its own, emptied first.
set -uo pipefail
cavity=$1 source=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch" || exit 1
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# A run of a moment.
tiny=(--spacing 5 --until 0.5 --sample 0.25 --frames 2 --quiet)

# refuses SENTENCE ARGUMENTS...: exit code 2, one sentence that contains SENTENCE, nothing on stdout, nothing written
refuses() {
  local sentence=$1 code
  shift
  "$cavity" --out refused "$@" >stdout 2>stderr
  code=$?
  [ $code -eq 2 ] || fail "exit code $code, not 2: cavity $*"
  [ "$(wc -l <stderr)" -eq 1 ] || fail "not one line on stderr: cavity $*: $(cat stderr)"
  grep -qF -e "$sentence" stderr || fail "cavity $* said '$(cat stderr)', not '$sentence'"
  [ ! -s stdout ] || fail "cavity $* wrote to stdout"
  [ ! -e refused ] || fail "cavity $* made its directory"
  rm -rf refused
}

bad_words() {
  refuses "'--speeed' is not an option" --speeed 3
  refuses "'more' is not an option" more
  refuses "speed" --speed fast
  refuses "--seed is -1; it must be >= 0" --seed -1
  refuses "--preset is 'best'; choose paper, accurate or quick" --preset best
  refuses "--shape is 'round'; choose linear, gimp, cpgimp, quadratic or cubic" --shape round
  refuses "--transfer aflip is not available with --shape gimp; it needs --transfer flip" --shape gimp
  refuses "--transfer is 'pic'; choose flip, apic, aflip, xpic or fmpm" --transfer pic
  refuses "--update is 'usm'; choose usl, musl or usf" --update usm
  refuses "--sleep is 'deep'; choose on or off" --sleep deep
  refuses "--fill is 'sand'; choose lattice or fraction" --fill sand
  refuses "--domain is 'half'; choose full or quarter" --domain half
  refuses "--precision is 'half'; choose double or float" --precision half
}

bad_values() {
  refuses "--spacing is -1 um; it must be > 0" --spacing -1
  refuses "--spacing is 0 um; it must be > 0" --spacing 0
  refuses "--spacing is nan um; it must be > 0" --spacing nan
  refuses "--spacing is 3 um, which does not divide the body" --spacing 3
  refuses "--spacing is 20 um, which does not divide the body" --spacing 20
  refuses "the most is 2^31" --spacing 0.01
  refuses "--until is 0 ns; it must be > 0" --until 0
  refuses "--until is -2 ns; it must be > 0" --until -2
  refuses "--sample is 0 ns; it must be > 0" --sample 0
  refuses "more than a million rows" --sample 1e-9
  refuses "--per-axis is 0; it must be from 1 to 8" --per-axis 0
  refuses "--per-axis is 9; it must be from 1 to 8" --per-axis 9
  refuses "--jitter is 0.6; it must be from 0 to 0.5" --jitter 0.6
  refuses "'--speed' has no value" --speed ""
  refuses "'--until=' has no value" --until= --dry-run
  refuses "--courant is 0; it must be from 0.001 to 1" --courant 0
  refuses "--courant is 1.5; it must be from 0.001 to 1" --courant 1.5
  refuses "--threads is -1; it must be from 0 (all) to 1024" --threads -1
  refuses "--frames is 1; it must be 0 (none) or from 2" --frames 1
  refuses "--speed is 1e+06 m/s; it must be from -5000 to 5000" --speed 1e6
  refuses "--conductivity is -1 W/(m K); it must be from 0" --conductivity -1
  refuses "--sleep on does not go with --conductivity 237" --conductivity 237 --sleep on
  refuses "it needs --fill lattice" --conductivity 237 --preset paper --fill fraction
  refuses "--conductivity 237 is not available with --shape cubic" --conductivity 237 --shape cubic
  refuses "--yield is 0 MPa; it must be > 0" --yield 0
  refuses "--hardening is -1 MPa; it must be from 0" --hardening -1
}

bad_cavities_and_combinations() {
  refuses "--radius is -1 um; it must be >= 0" --radius -1
  refuses "touches the wall; with --centre-z 10 it must be below 10" --radius 10
  refuses "touches the free surface; with --centre-z 45 it must be below 5" --radius 6 --centre-z 45
  refuses "touches its periodic image; it must be below 20" --radius 20 --centre-z 25
  refuses "--centre-z is 60 um, outside the body" --centre-z 60
  refuses "less than a cell" --radius 0.5
  refuses "--flip-blend does not go with --transfer apic; it needs --transfer flip or aflip" --flip-blend 0.5 --transfer apic
  refuses "--flip-blend is 2; it must be from 0 to 1" --transfer flip --flip-blend 2
  refuses "--order does not go with --transfer apic; it needs --transfer xpic, fmpm or aflip" --transfer apic --order 2
  refuses "--order is 0; it must be from 1 to 40" --transfer xpic --order 0
  refuses "--transfer xpic is not available with --shape cubic --update usl; flip, apic and aflip" --transfer xpic --shape cubic
  refuses "--precision float is not available with --shape linear --transfer aflip" --precision float --shape linear
  refuses "it is with quadratic aflip usl, quadratic apic usl, cubic aflip usl and linear flip musl" --precision float --shape cubic --update musl
}

bad_directories() {
  mkdir occupied && touch occupied/something file
  refuses "--out occupied is not empty; name another directory, or say --overwrite" --out occupied
  [ "$(ls occupied)" = something ] || fail "a refused run touched its directory"
  refuses "--out file is there and is no directory" --out file
  refuses "cannot be made" --out file/below
  if [ "$(id -u)" -ne 0 ]; then
    mkdir locked && chmod a-w locked
    refuses "--out locked cannot be written to" --out locked
  fi
}

dry_run() {
  "$cavity" --preset paper --speed 400 --out dry --dry-run >stdout 2>stderr || fail "--dry-run fails: $(cat stderr)"
  [ ! -e dry ] || fail "--dry-run made a directory"
  for line in "preset +paper" "speed_m_s +400" "shape +linear" "transfer +flip" "domain +full" "fill +lattice" \
    "particles +635811" "steps +[0-9]" "memory_mb +[0-9]"; do
    grep -qE "^$line" stdout || fail "--dry-run does not say $line"
  done
  "$cavity" --help >stdout 2>&1 || fail "--help fails"
  grep -q -e --centre-z stdout || fail "--help does not list the options"
}

# good NAME ARGUMENTS...: runs to the end into the directory NAME
good() {
  local name=$1
  shift
  "$cavity" "${tiny[@]}" --out "$name" "$@" >stdout 2>stderr || fail "cavity ${tiny[*]} --out $name $*: $(cat stderr)"
  [ ! -s stderr ] || fail "cavity --quiet $* wrote to stderr: $(cat stderr)"
}

runs() {
  good solid --radius 0
  for scheme in "linear flip usl" "linear flip musl" "linear apic musl" "quadratic flip musl" "quadratic apic usl" \
    "gimp flip usl" "gimp flip musl" "cpgimp flip usl" "cpgimp flip musl" \
    "cubic flip usl" "cubic flip musl" "cubic apic usl" "cubic apic musl" \
    "quadratic aflip usl" "quadratic aflip musl" "cubic aflip usl" "linear flip usf" "quadratic flip usf" \
    "quadratic apic usf" "linear xpic musl" "quadratic xpic usl" "quadratic xpic usf" "quadratic fmpm usl"; do
    read -r shape transfer update <<<"$scheme"
    good "$shape-$transfer-$update" --shape "$shape" --transfer "$transfer" --update "$update" --frames 0
  done
  good full --domain full --fill lattice
  good quarter --fill lattice
  good float --precision float --frames 0
  good cubic-float --precision float --shape cubic --frames 0
  good order --transfer xpic --order 2 --frames 0
  good warm --conductivity 237 --frames 0
  good warm-paper --preset paper --conductivity 237 "${tiny[@]}" --frames 0
  good into-wall --speed -100 --jitter 0.2 --seed 7 --frames 0 --threads 3 --flip-blend 0.9 --transfer flip
}

# Every column of a quarter's history is the full body's, to 1e-6 of the column's maximum.
quarter_is_full() {
  local domain
  for domain in full quarter; do
    "$cavity" --spacing 2.5 --until 3 --frames 0 --quiet --domain $domain --out "history-$domain" >stdout 2>stderr ||
      fail "a $domain domain to 3 ns does not run: $(cat stderr)"
  done
  paste -d, history-full/history.csv history-quarter/history.csv | awk -F, '
    NR == 1 { columns = NF / 2; for (c = 1; c <= columns; ++c) name[c] = $c; next }
    { for (c = 1; c <= columns; ++c) {
        a = $c; b = $(c + columns)
        if ((a == "nan") != (b == "nan")) { print name[c] " is nan in one run only"; exit 1 }
        if (a == "nan") continue
        size = a < 0 ? -a : a + 0; gap = a > b ? a - b : b - a
        if (size > largest[c]) largest[c] = size
        if (gap > apart[c]) apart[c] = gap } }
    END { for (c = 1; c <= columns; ++c) if (apart[c] > 1e-6 * largest[c]) { print name[c] " differs by " apart[c]; exit 1 } }
    ' >stdout || fail "the histories of a quarter and of the full body differ: $(cat stdout)"
}

outputs() {
  local header=time_ns,step,vz_min_m_s,vz_max_m_s,vz_low_m_s,vz_high_m_s,vz_min_grid_m_s,vz_max_grid_m_s,p_min_mpa
  header+=,p_max_mpa,t_max_k,cavity_volume_um3,cavity_width_um,cavity_height_um,kinetic_j,elastic_j,plastic_j,viscous_j
  header+=,transfer_loss_j,energy_error,mass_kg,momentum_z_kg_m_s,wall_impulse_z_n_s,active_fraction
  [ "$(head -1 full/history.csv)" = "$header" ] || fail "the columns of history.csv are others"
  [ "$(head -1 full/axis.csv)" = time_ns,z_um,vz_m_s,p_mpa,t_k,rho_kg_m3 ] || fail "the columns of axis.csv are others"
  [ "$(wc -l <full/history.csv)" -eq 4 ] || fail "history.csv does not have three samples"
  awk -F, 'NF != 24 { exit 1 }' full/history.csv || fail "a row of history.csv is torn"
  awk -F, 'NR > 1 { t[$1] } END { exit length(t) != 2 }' full/axis.csv || fail "axis.csv does not have two times"
  for key in version configuration particles steps wall_seconds step_seconds ns_per_particle_step peak_memory_bytes; do
    grep -q "\"$key\": [^n]" full/summary.json || fail "summary.json lacks $key"
  done
  for n in particles_0000.vtp particles_0001.vtp particles.pvd grid_0000.vti grid_0001.vti grid.pvd; do
    [ -s "full/frames/$n" ] && [ -s "quarter/frames/$n" ] || fail "frames/$n is missing"
  done
  # the full body also where a quarter ran, and the same mass
  cut -d, -f21 full/history.csv | tail -1 >mass && cut -d, -f21 quarter/history.csv | tail -1 >>mass
  awk '{ m[NR] = $1 } END { exit !((m[1] / m[2] - 1) ^ 2 < 1e-24) }' mass || fail "quarter and full differ in mass"
  [ "$(grep -o 'NumberOfPoints="[0-9]*"' full/frames/particles_0000.vtp)" = \
    "$(grep -o 'NumberOfPoints="[0-9]*"' quarter/frames/particles_0000.vtp)" ] ||
    fail "a quarter's frame is not the body"
  /usr/bin/python3 "$source/tests/unit/observe/read_vtk.py" . >stdout 2>stderr
  case $? in
    0) ;;
    2) echo "the frames were not read back: $(cat stderr)" ;;
    *) fail "frames: $(cat stderr)" ;;
  esac
}

overwriting() {
  good again
  refuses "--out again is not empty" --out again
  touch again/mine again/frames/particles_0099.vtp
  good again --overwrite --frames 0
  [ -e again/mine ] || fail "--overwrite removed a file that is not the program's"
  [ ! -e again/frames/particles_0099.vtp ] || fail "--overwrite left an earlier run's frame"
}

# disk_full CODE: the exit code is 1, and there is one sentence
disk_full() {
  local code=$1
  [ "$code" -eq 1 ] || fail "a full disk gives exit code $code, not 1"
  [ "$(wc -l <stderr)" -eq 1 ] || fail "a full disk gives not one line: $(cat stderr)"
  grep -q "cannot write" stderr || fail "a full disk gives '$(cat stderr)'"
}

full_disks() {
  mkdir device && ln -s /dev/full device/history.csv
  "$cavity" "${tiny[@]}" --out device --overwrite >stdout 2>stderr
  disk_full $?
  # no file beyond 8 KiB, the signal ignored: history.csv stops in the middle of its rows
  (trap '' XFSZ && ulimit -f 8 && exec "$cavity" --spacing 5 --until 8 --sample 0.02 --frames 0 --quiet --out small) \
    >stdout 2>stderr
  disk_full $?
  awk -F, 'NF != 24 { exit 1 } END { exit NR < 5 }' small/history.csv || fail "history.csv of a full disk is torn"
  [ ! -e small/summary.json ] || fail "a run that could not write has a summary"
}

# The equation of state does not cover what this run gets to: one sentence, and the last state as a frame.
failing_run() {
  "$cavity" --speed -5000 --shape linear --transfer flip --spacing 5 --courant 1 --frames 3 --quiet --out failing \
    >stdout 2>stderr
  [ $? -eq 1 ] || fail "a run that fails does not end with 1"
  [ "$(wc -l <stderr)" -eq 1 ] || fail "a run that fails says '$(cat stderr)'"
  grep -q "^cavity: particle .* in step" stderr || fail "a run that fails says '$(cat stderr)'"
  [ -s failing/frames/particles_0001.vtp ] || fail "a run that fails does not leave its last state"
  grep -q '"failure": "' failing/summary.json || fail "the summary of a run that fails does not say so"
}

bad_words
bad_values
bad_cavities_and_combinations
bad_directories
dry_run
runs
quarter_is_full
outputs
overwriting
full_disks
failing_run
[ $failures -eq 0 ] && echo "all as expected"
[ $failures -eq 0 ]
