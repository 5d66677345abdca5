#!/usr/bin/python3
"""The cavity in a ball: the library in three dimensions beside the spherical reference solver.

    mote_studies "[spherical-table]" | grep -E '^[0-9.]+,' > spherical.csv
    /usr/bin/python3 tests/reference/plot_spherical.py spherical.csv docs/pictures/spherical_reference.png

Rows: h (um; 0: the reference alone), time (ns), radius of the cavity, radius in the reference (um).
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def read(path):
    """h -> rows of (time, radius, reference)."""
    runs = {}
    with open(path) as file:
        for h, *numbers in csv.reader(file):
            runs.setdefault(float(h), []).append([float(x) for x in numbers])
    return runs


def draw(runs, path):
    figure, (radius, error) = plt.subplots(1, 2, figsize=(11, 4.2), constrained_layout=True)
    reference = runs.pop(0.0)
    radius.plot([t for t, _, _ in reference], [a for _, a, _ in reference], color="black", lw=1.2,
                label="spherical reference, one dimension")
    for (h, rows), colour, marker in zip(sorted(runs.items(), reverse=True), ("C1", "C0", "C2"), "v^o"):
        times = [t for t, _, _ in rows]
        label = f"mote, three dimensions, h = {h:g} µm"
        radius.plot(times, [a for _, a, _ in rows], marker, color=colour, ms=4.5, mfc="none", label=label)
        error.plot(times, [100 * (a / b - 1) for _, a, b in rows], marker + "-", color=colour, ms=4.5, lw=1, label=label)
    radius.set(xlabel="time, ns", ylabel="radius of the cavity, µm", xlim=(0, 10), title="The cavity is torn open, and again by the echo")
    radius.legend(frameon=False, loc="lower right", fontsize=9)
    error.axhspan(-1, 1, color="0.9", zorder=0)
    error.axhline(0, color="black", lw=0.8)
    error.text(0.15, 0.8, "within 1%", fontsize=9, color="0.35")
    error.set(xlabel="time, ns", ylabel="radius against the reference, %", xlim=(0, 10), title="The error falls with the mesh")
    error.legend(frameon=False, loc="lower left", fontsize=9)
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    draw(read(sys.argv[1]), sys.argv[2])
