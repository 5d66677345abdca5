#!/usr/bin/python3
"""Tests the paper's claims on the runs and prints the tables of docs/reproduction.md.

claims.py DIR SET                 writes DIR/claims.md from the runs in DIR; SET is full or coarse
claims.py DIR SET --into FILE     writes the tables between FILE's markers too

Exit code: 0 done, 1 a run is missing.
"""

import pathlib
import re
import sys

import catalogue
import claims_fields
import claims_growth
import claims_motion
import measures
from figures import Runs
from rows import HEAD, number, percent


def choices(runs):
    """Lines: what each reading of the paper changes, against the default reading on the same mesh."""
    listing = (runs.folder / "choices.txt").read_text().splitlines()
    names = [line.split(None, 1) for line in listing]
    columns = (("cavity_volume_um3", 7.2, "V, 7.2 ns"), ("cavity_volume_um3", 12, "V, 12 ns"),
               ("vz_high_m_s", 7.2, "high, 7.2 ns"), ("vz_low_m_s", 3, "low, 3 ns"), ("vz_low_m_s", 7.2, "low, 7.2 ns"),
               ("t_max_k", 12, "hottest, 12 ns"))
    lines = ["| reading | launch, m/s | " + " | ".join(c[2] for c in columns) + " |", "|---" * (len(columns) + 2) + "|"]
    for name, what in names:
        for speed in catalogue.CHOICE_SPEEDS:
            run, usual = (runs[f"choice_{n}_v{speed}"] for n in (name, "default"))
            cells = []
            for column, time, _ in columns:
                value, base = run.at(time, column), usual.at(time, column)
                offset = 300 if column == "t_max_k" else 0
                cells.append(number(value - offset) if run is usual else
                             "-" if value != value else percent((value - offset) / (base - offset) - 1, 1))
            if run.summary["failure"]:
                cells[0] = f"broke down at {run.history['time_ns'][-1]:.1f} ns"
            lines.append("| {} | {} | ".format(what.replace("|", "\\|"), speed) + " | ".join(cells) + " |")
    return lines


def ledger(runs):
    """Lines: how well energy closes, and single particles' pressures, by mesh."""
    lines = ["| launch, m/s | scheme | energy error, 7.2 ns | 15 ns | pressures at 7.2 ns, GPa | greatest pressure, GPa, and when |",
             "|---|---|---|---|---|---|"]
    for speed in (100, 1000):
        for name, run in (("paper's", runs.paper(speed)), *(("default", runs.default(h, speed)) for h in runs.mesh_sequence(speed))):
            errors = " | ".join(percent(run.at(time, "energy_error"), 2) for time in (7.2, 15))
            low, high = (1e-3 * run.at(7.2, f"p_{side}_mpa") for side in ("min", "max"))
            pressures = run.history["p_max_mpa"]
            when = run.history["time_ns"][pressures.argmax()]
            lines.append(f"| {speed} | {name}, {run.config['spacing_um']:g} µm | {errors} | {low:.2f} to {high:.2f} | "
                         f"{1e-3 * pressures.max():.2f}, {when:.1f} ns |")
    return lines


def tables(runs):
    rows = claims_motion.rows(runs) + claims_fields.rows(runs) + claims_growth.rows(runs)
    return {"claims": [HEAD, *(row.markdown() for row in rows)], "volumes": claims_growth.volumes(runs), "ledger": ledger(runs),
            "extremes": claims_motion.sizes_of_extremes(runs), "choices": choices(runs)}


def insert(file, found):
    """Replaces what stands between `<!-- table NAME -->` and `<!-- end -->`."""
    text = file.read_text()
    for name, lines in found.items():
        block = f"<!-- table {name} -->\n" + "\n".join(lines) + "\n<!-- end -->"
        text, count = re.subn(f"<!-- table {name} -->.*?<!-- end -->", lambda _: block, text, flags=re.S)
        if count != 1:
            raise measures.Missing(f"{file} has {count} places for the table {name}; it must have one")
    file.write_text(text)


def main():
    runs = Runs(sys.argv[1], sys.argv[2])
    try:
        found = tables(runs)
        text = "\n\n".join("\n".join(lines) for lines in found.values())
        (runs.folder / "claims.md").write_text(text + "\n")
        print(text)
        if "--into" in sys.argv:
            insert(pathlib.Path(sys.argv[sys.argv.index("--into") + 1]), found)
    except (measures.Missing, OSError) as reason:
        print(f"the claims cannot be tested: {reason}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
