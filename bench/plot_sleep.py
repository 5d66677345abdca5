#!/usr/bin/python3
"""What sleep saves, and what it costs in accuracy, against its tolerance.

    /usr/bin/python3 bench/plot_sleep.py build/cavity-release/examples/cavity/cavity docs/pictures/sleep.png [ROUNDS]

Runs `cavity --preset accurate --until 7 --frames 0 --threads 1` with sleep off and on at each tolerance, in turn, ROUNDS
times (3). Prints a table and draws it: the largest change of any column of history.csv, relative to that column's
maximum, and the wall time of the steps without sleep over that with it.
"""
import csv
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

DEFAULT, DEMANDED = 2e-10, 1e-9
TOLERANCES = sorted([10.0**e for e in range(-16, -5)] + [DEFAULT])


def run(cavity, out, *options):
    """Seconds in steps, and history.csv as columns."""
    command = [cavity, "--preset", "accurate", "--until", "7", "--frames", "0", "--threads", "1", "--quiet"]
    subprocess.run([*command, "--overwrite", "--out", out, *options], check=True, stdout=subprocess.DEVNULL)
    with open(pathlib.Path(out) / "history.csv") as file:
        rows = list(csv.DictReader(file))
    seconds = json.loads((pathlib.Path(out) / "summary.json").read_text())["step_seconds"]
    return seconds, {name: [float(row[name]) for row in rows] for name in rows[0]}


def largest_change(history, reference):
    """Of any column but active_fraction, relative to its maximum; and the column."""
    worst = (0.0, "")
    for name, column in reference.items():
        if name == "active_fraction":
            continue
        pairs = [(a, b) for a, b in zip(history[name], column) if a == a or b == b]
        size = max((abs(b) for _, b in pairs), default=0)
        change = max((abs(a - b) for a, b in pairs), default=0)
        if change > 0:
            worst = max(worst, (change / size, name))
    return worst


def measure(cavity, rounds):
    """(tolerance, change, column, mean active fraction, ratios) for each tolerance."""
    found = {}
    with tempfile.TemporaryDirectory() as out:
        for _ in range(rounds):
            for tolerance in TOLERANCES:
                off, reference = run(cavity, out, "--sleep", "off")
                on, history = run(cavity, out, "--sleep", "on", "--sleep-tolerance", repr(tolerance))
                change, name = largest_change(history, reference)
                active = statistics.mean(history["active_fraction"][1:])
                found.setdefault(tolerance, (tolerance, change, name, active, []))[4].append(off / on)
    return [found[t] for t in TOLERANCES]


def draw(results, picture):
    figure, (above, below) = plt.subplots(2, 1, figsize=(7, 6), sharex=True, layout="constrained")
    tolerances = [r[0] for r in results]
    above.loglog(tolerances, [r[1] for r in results], "o-", color="tab:blue")
    above.axhline(DEMANDED, color="grey", linestyle="--")
    above.annotate("demanded: 1e-9", (tolerances[0], DEMANDED), textcoords="offset points", xytext=(0, 4), color="grey")
    above.set_ylabel("change of a column of\nhistory.csv, of its maximum")
    for r in results:
        below.semilogx([r[0]] * len(r[4]), r[4], ".", color="tab:orange", alpha=0.5)
    below.semilogx(tolerances, [statistics.median(r[4]) for r in results], "o-", color="tab:orange", label="measured")
    below.semilogx(tolerances, [1 / r[3] for r in results], ":", color="black",
                   label="1 / mean fraction of particles awake")
    below.set_ylabel("steps' wall time, off / on")
    below.set_xlabel("tolerance of sleep")
    below.legend(loc="upper left")
    for axes in (above, below):
        axes.axvline(DEFAULT, color="tab:green")
        axes.grid(alpha=0.3)
    above.text(DEFAULT, 0.05, " default", transform=above.get_xaxis_transform(), color="tab:green")
    above.set_title("cavity --preset accurate --until 7 --frames 0 --threads 1", fontsize=10)
    figure.savefig(picture, dpi=120)


def main():
    cavity, picture = sys.argv[1:3]
    results = measure(cavity, int(sys.argv[3]) if len(sys.argv) > 3 else 3)
    print("tolerance  change    active  off/on")
    for tolerance, change, name, active, ratios in results:
        print(f"{tolerance:8.0e}  {change:8.1e}  {active:5.3f}  {statistics.median(ratios):5.3f}  "
              f"({min(ratios):.3f} to {max(ratios):.3f})  {name}")
    draw(results, picture)


if __name__ == "__main__":
    main()
