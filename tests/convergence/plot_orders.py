#!/usr/bin/python3
"""Draws docs/pictures/orders.png from the markdown that `mote_slow_studies "orders: tables"` prints (its first argument)."""

import pathlib
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    print(f"no picture: {error} (Debian: apt install python3-matplotlib)", file=sys.stderr)
    sys.exit(1)

PICTURE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "pictures" / "orders.png"
COLOURS = {"linear": "#c0392b", "GIMP": "#d9730d", "cpGIMP": "#2e8b57", "quadratic": "#1f6fb4", "cubic": "#7b4fa3"}
MARKERS = {"FLIP": "o", "APIC": "s", "AFLIP": "D", "XPIC(5)": "^", "FMPM(2)": "v"}
LINES = {"USL": "-", "MUSL": "--", "USF": ":"}
BARS = ("bar, A = 0.05", "bar, A = 1e-4")


def read(name):
    """{problem: [(shape, transfer, update), [(cells, error), ...]]}"""
    tables, cells = {}, []
    for line in open(name):
        fields = [f.strip() for f in line.strip().strip("|").split("|")]
        if line.startswith("### "):
            rows = tables.setdefault(line[4:].strip(), [])
        elif line.startswith("| combination"):
            cells = [int(f[4:]) for f in fields if f.startswith("n = ")]
        elif line.startswith("| ") and cells:
            rows.append((fields[0].split(", "), list(zip(cells, map(float, fields[1:1 + len(cells)])))))
    return tables


def draw(axes, title, rows):
    for (shape, transfer, update), points in rows:
        points = [(1 / n, e) for n, e in points if e < 3]
        axes.loglog(*zip(*points) if points else ([], []), LINES[update], marker=MARKERS[transfer], ms=4, lw=1.1,
                    color=COLOURS[shape], alpha=0.75)
    ends = (1 / 256, 1 / 64)
    axes.loglog(ends, [2e-5, 2e-5 * 16], color="#444444", lw=1.5)
    axes.text(1 / 110, 6e-5, "order 2", color="#444444", fontsize=9)
    axes.set_title(title, fontsize=11)
    axes.set_xlabel("h, m")
    axes.set_ylim(2e-6, 3)
    axes.set_xticks([1 / 256, 1 / 128, 1 / 64, 1 / 32, 1 / 16], ["1/256", "1/128", "1/64", "1/32", "1/16"])
    axes.minorticks_off()
    axes.grid(color="#eeeeee")


def main():
    tables = read(sys.argv[1])
    figure, all_axes = plt.subplots(1, 2, figsize=(11, 5.2), sharey=True)
    for axes, bar in zip(all_axes, BARS):
        draw(axes, bar.replace("1e-4", "$10^{-4}$"), tables[bar])
    all_axes[0].set_ylabel("largest RMS error of position, over A")
    entries = [plt.Line2D([], [], color=c, lw=2, label=n) for n, c in COLOURS.items()]
    entries += [plt.Line2D([], [], color="#444444", marker=m, ls="", label=n) for n, m in MARKERS.items()]
    entries += [plt.Line2D([], [], color="#444444", ls=l, label=n) for n, l in LINES.items()]
    figure.legend(handles=entries, frameon=False, fontsize=9, ncol=13, loc="lower center", columnspacing=1.1,
                  handlelength=1.6)
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    figure.savefig(PICTURE, dpi=110)


if __name__ == "__main__":
    main()
