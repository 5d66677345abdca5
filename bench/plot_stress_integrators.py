#!/usr/bin/python3
"""Draws docs/pictures/stress_integrators.png from the CSV of mote_bench_stress_integrators (its first argument)."""

import csv
import pathlib
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    print(f"no picture: {error} (Debian: apt install python3-matplotlib)", file=sys.stderr)
    sys.exit(1)

PICTURE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "pictures" / "stress_integrators.png"
COLOURS = {"radial return": "#d9730d", "exponential map": "#1f6fb4"}
LINES = {"none": ("-", "o", "no hardening"), "5 GPa both": ("--", "s", "$H_{iso}$ = $H_{kin}$ = 5 GPa")}
MAPS = [("radial return", "none"), ("radial return", "5 GPa both"), ("exponential map", "5 GPa both")]


def read(name):
    paths, maps = {}, {}
    with open(name, newline="") as file:
        for kind, hardening, integrator, *numbers in csv.reader(file):
            (paths if kind == "path" else maps).setdefault((integrator, hardening), []).append(
                [float(n) for n in numbers])
    return paths, maps


def draw_paths(axes, paths):
    for (integrator, hardening), rows in paths.items():
        line, marker, words = LINES[hardening]
        axes.loglog(*zip(*rows), line, marker=marker, ms=4.5, color=COLOURS[integrator], label=f"{integrator}, {words}")
    for order, start, colour in ((1, 0.3, COLOURS["radial return"]), (2, 0.012, COLOURS["exponential map"])):
        ends = [40, 160]
        axes.loglog(ends, [start, start * (ends[0] / ends[1])**order], color="#777777", lw=1)
        axes.text(85, start * 0.5**order * 1.35, f"order {order}", color="#555555", fontsize=9)
    axes.set_xlabel("steps along the path")
    axes.set_ylabel("largest error of s, in yield radii")
    axes.set_title("A corner and a curve", fontsize=11)
    axes.legend(frameon=False, fontsize=8.5, loc="lower left")
    axes.grid(color="#eeeeee")


def draw_map(axes, rows, integrator, hardening):
    size = int(round((len(rows) + 1)**0.5))
    values = [0.0] + [r[2] for r in rows]
    grid = [[100 * values[i * size + j] for i in range(size)] for j in range(size)]
    ticks = [0.1 * i for i in range(size)]
    top = max(map(max, grid))
    levels = [l for l in ((0.05, 0.1, 0.2) if top < 1 else (1, 2, 4, 6, 8, 10, 12, 15, 20)) if l < top]
    shade = axes.contourf(ticks, ticks, grid, levels=[0.2 * k for k in range(0, 121)], cmap="YlOrBr", extend="max")
    lines = axes.contour(ticks, ticks, grid, levels=levels, colors="#333333", linewidths=0.8)
    axes.clabel(lines, fmt=lambda v: f"{v:g}%", fontsize=8)
    axes.set_title(f"{integrator}, {LINES[hardening][2]}\nlargest {top:.2g}%", fontsize=10.5)
    axes.set_xlabel("increment along the stress, yield strains")
    axes.set_ylabel("across the stress")
    axes.set_aspect("equal")
    return shade


def main():
    paths, maps = read(sys.argv[1])
    figure, axes = plt.subplots(2, 2, figsize=(10.5, 9.5))
    draw_paths(axes[0][0], paths)
    for place, key in zip((axes[0][1], axes[1][0], axes[1][1]), MAPS):
        draw_map(place, maps[key], *key)
    exact = max(r[2] for r in maps["exponential map", "none"])
    print(f"exponential map without hardening: largest error of an increment {exact:.2g}")
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110)


main()
