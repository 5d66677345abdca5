#!/usr/bin/python3
"""Draws docs/pictures/accuracy_*.png from CSV files of mote_bench_accuracy (its arguments): error against run time of
every scheme, mesh and number of particles, and the Pareto front: runs than which none is both cheaper and better.
Prints the fronts as tables."""

import csv
import math
import pathlib
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.lines import Line2D
except ImportError as error:
    print(f"no picture: {error} (Debian: apt install python3-matplotlib)", file=sys.stderr)
    sys.exit(1)

PICTURES = pathlib.Path(__file__).resolve().parent.parent / "docs" / "pictures"
COLOURS = {"flip": "#d9730d", "flip0.99": "#e8b04a", "apic": "#1f6fb4", "aflip": "#c2185b", "xpic": "#2e8b57",
           "fmpm": "#7b5ea7"}
WORDS = {"flip": "FLIP", "flip0.99": "FLIP 0.99", "apic": "APIC", "aflip": "AffineFlip", "xpic": "XPIC(5)",
         "fmpm": "FMPM(2)"}
MARKERS = {"linear": "v", "cpgimp": "D", "quadratic": "o", "cubic": "s"}
SHAPES = {"linear": "linear", "cpgimp": "contiguous GIMP", "quadratic": "quadratic", "cubic": "cubic"}
UPDATES = ("usl", "musl", "usf")
FIGURES = {
    "smooth": [("bar", "bar, A = 0.05"), ("vortex", "vortex, 0.4 rad")],
    "waves": [("wave_100", "tension, 100 m/s: velocity"), ("wave_400", "tension, 400 m/s: velocity"),
              ("wave_-500", "compression, 500 m/s: velocity"), ("plateau_100", "tension, 100 m/s: stress behind"),
              ("plateau_400", "tension, 400 m/s: stress behind"),
              ("plateau_-500", "compression, 500 m/s: stress behind")],
    "cavity": [("volume_100", "cavity, 100 m/s: volume"), ("volume_400", "cavity, 400 m/s: volume"),
               ("speeds_100", "cavity, 100 m/s: low and high"), ("speeds_400", "cavity, 400 m/s: low and high")],
}
WORST = 1.0  # errors above are failures and are not drawn


def read(names):
    problems, failed = {}, {}
    for name in names:
        with open(name, newline="") as file:
            for row in csv.DictReader(line for line in file if not line.startswith("#")):
                error, problem = float(row["error"]), row["problem"]
                if row["scheme"].split()[1] not in COLOURS:  # a part of a scheme, for the table of the docs
                    continue
                if not math.isfinite(error) or error > WORST:
                    failed.setdefault(problem, []).append(row)
                else:
                    problems.setdefault(problem, []).append(
                        (float(row["seconds"]), error, *row["scheme"].split(), float(row["h"]), int(row["per_axis"])))
    return problems, failed


def front(points):
    best, found = math.inf, []
    for point in sorted(points):
        if point[1] < best:
            best = point[1]
            found.append(point)
    return found


def draw_points(axes, points, on_front):
    for point in points:
        seconds, error, shape, transfer, update, _, _ = point
        colour, strong = COLOURS[transfer], point in on_front
        axes.plot([seconds], [error], MARKERS[shape], ms=8 if strong else 4.5, alpha=1 if strong else 0.45,
                  color=colour, mfc="white" if update == "musl" else colour,
                  mec="#555555" if update == "usf" else colour, mew=1.1, zorder=3 if strong else 2)


def draw(axes, points, title):
    best = front(points)
    draw_points(axes, points, best)
    if best:
        axes.plot(*zip(*[p[:2] for p in best]), color="#222222", lw=1.2, zorder=1)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(title, fontsize=11)
    axes.grid(color="#eeeeee", which="both", lw=0.6)
    axes.set_axisbelow(True)


def legend(figure, used):
    entries = [Line2D([], [], ls="", marker="o", color=COLOURS[t], label=WORDS[t]) for t in COLOURS if t in used]
    entries += [Line2D([], [], ls="", marker=MARKERS[s], color="#666666", label=SHAPES[s])
                for s in MARKERS if s in used]
    styles = {"usl": dict(mfc="#666666", mec="#666666"), "musl": dict(mfc="white", mec="#666666"),
              "usf": dict(mfc="#bbbbbb", mec="#222222")}
    entries += [Line2D([], [], ls="", marker="o", label=u.upper(), **styles[u]) for u in UPDATES if u in used]
    entries.append(Line2D([], [], color="#222222", lw=1.2, label="Pareto front (large marks)"))
    figure.legend(handles=entries, loc="lower center", ncol=7, frameon=False, fontsize=10)


def print_front(title, points, failed):
    print(f"\n{title}: {len(points)} runs, {failed} failed or worse than {WORST:.0%}")
    print("| s | error | shape | transfer | update | h | per axis |\n|---|---|---|---|---|---|---|")
    for p in front(points):
        print(f"| {p[0]:.2g} | {p[1]:.2g} | {p[2]} | {p[3]} | {p[4]} | {p[5]:.3g} | {p[6]} |")


def main():
    problems, failed = read(sys.argv[1:])
    for name, panels in FIGURES.items():
        panels = [p for p in panels if p[0] in problems]
        if not panels:
            continue
        columns = 3 if len(panels) > 4 else 2
        rows = (len(panels) + columns - 1) // columns
        figure, axes = plt.subplots(rows, columns, figsize=(5.2 * columns, 4.3 * rows + 1.0), squeeze=False)
        for place, (problem, title) in zip(axes.flat, panels):
            draw(place, problems[problem], title)
            print_front(title, problems[problem], len(failed.get(problem, [])))
        for place in axes.flat[len(panels):]:
            place.set_visible(False)
        for row in axes:
            row[0].set_ylabel("relative error")
        for place in axes[-1]:
            place.set_xlabel("seconds on one core")
        figure.tight_layout(rect=(0, 0.9 / (4.3 * rows + 1.0), 1, 1))
        legend(figure, {word for p in panels for point in problems[p[0]] for word in point[2:5]})
        figure.savefig(PICTURES / f"accuracy_{name}.png", dpi=100)


main()
