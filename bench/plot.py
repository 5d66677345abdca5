#!/usr/bin/python3
"""Draws docs/pictures/performance_step.png and performance_scaling.png from the results of bench/run_all.sh."""

import statistics
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    print(f"no picture: {error} (Debian: apt install python3-matplotlib)", file=sys.stderr)
    sys.exit(1)

import results

PICTURES = results.ROOT / "docs" / "pictures"
PHASES = [("scatter", "particles to grid", "#1f6fb4"),
          ("grid", "grid: forces, walls", "#7f7f7f"),
          ("gather", "grid to particles", "#d9730d"),
          ("second_grid", "second grid velocity (MUSL)", "#bdbdbd"),
          ("deform", "stress from it (MUSL)", "#f0b35a")]
GREY, REST = "#444444", "#cfe3cf"


def clean(axes, *sides):
    for side in sides:
        axes.spines[side].set_visible(False)
    axes.tick_params(length=0)


def draw_bars(axes, schemes, ratios):
    for y, (name, r) in enumerate(schemes):
        left = 0
        for phase, _, colour in PHASES:
            width = r.get(phase + "_ns", 0)
            axes.barh(y, width, left=left, color=colour, height=0.62)
            left += width
        step = r["step_ns"]
        axes.barh(y, max(step - left, 0), left=left, color=REST, height=0.62)
        axes.plot([r["floor_ns"]] * 2, [y - 0.42, y + 0.42], color="black", lw=2.2, solid_capstyle="butt")
        axes.text(max(step, left) + 4, y, f"{step:.0f}", va="center", color=GREY, fontsize=10)
        if name in ratios:
            at = ratios[name] * step
            axes.plot([step + 30, at], [y, y], color="#cccccc", lw=1, ls=":", zorder=0)
            axes.plot(at, y, "D", color="#b2182b", ms=7)
            words = f"{at:.0f}, {ratios[name]:.1f} times as long"
            axes.text(at + 7, y, words, va="center", color="#b2182b", fontsize=10)


def legend(figure):
    patches = [(plt.Rectangle((0, 0), 1, 1, color=colour), words) for _, words, colour in PHASES]
    patches.append((plt.Rectangle((0, 0), 1, 1, color=REST), "checks, time step"))
    floor = plt.Line2D([], [], color="black", marker="|", ls="", ms=14, mew=2.2)
    loop = plt.Line2D([], [], color="#b2182b", marker="D", ls="", ms=7)
    patches += [(floor, "least this machine could need\nfor the operations and bytes"),
                (loop, "a plain textbook loop\non the same scene")]
    figure.legend(*zip(*patches), loc="lower center", ncol=3, frameon=False, fontsize=10.5, columnspacing=2.5)


def picture_of_steps():
    schemes = results.schemes()
    if not schemes:
        return
    step = results.rows("step")
    ratios = {name.removeprefix("textbook/"): r["ratio"] for name, r in step.items() if name.startswith("textbook/")}
    figure, axes = plt.subplots(figsize=(10.5, 7.2))
    draw_bars(axes, schemes, ratios)
    axes.set_yticks(range(len(schemes)), [results.title(name) for name, _ in schemes], fontsize=11)
    axes.invert_yaxis()
    axes.set_xlim(0, 1.3 * max([r["step_ns"] * ratios.get(n, 1) for n, r in schemes]))
    axes.set_xlabel("nanoseconds per particle and step, one core, double precision (shorter is better)", fontsize=11)
    axes.set_title("What a step costs, and where the time goes", loc="left", fontsize=14)
    clean(axes, "top", "right", "left")
    axes.grid(axis="x", color="#eeeeee", zorder=-1)
    axes.set_axisbelow(True)
    figure.tight_layout(rect=(0, 0.14, 1, 1))
    legend(figure)
    figure.savefig(PICTURES / "performance_step.png", dpi=110)


def draw_size(axes, found, scale):
    rows = [r for name, r in found.items() if name.startswith("particles/")]
    rows.sort(key=lambda r: r["particles"])
    axes.plot([r["particles"] for r in rows], [scale * r["relative"] for r in rows], "o-", color="#1f6fb4", ms=8, lw=2)
    for r in rows:
        axes.annotate(f"{scale * r['relative']:.0f}", (r["particles"], scale * r["relative"]), (0, 10),
                      textcoords="offset points", ha="center", color="#1f6fb4", fontsize=11)
    axes.text(rows[0]["particles"], scale * rows[0]["relative"] * 0.80, "one core", color="#1f6fb4", fontsize=11)
    two = found.get("two_threads")
    if two and two.get("share", 1) > 0.9:  # else others used the cores
        axes.plot(two["particles"], scale * two["relative"], "s", color="#d9730d", ms=9)
        axes.annotate(f"two cores: {scale * two['relative']:.0f}", (two["particles"], scale * two["relative"]),
                      (0, -20), textcoords="offset points", ha="center", color="#d9730d", fontsize=11)
    axes.set_xscale("log")
    axes.set_xlabel("particles (8 per cell)", fontsize=11)
    axes.set_title("cost against size", loc="left", fontsize=12)


def draw_per_cell(axes, found, scale):
    rows = [r for name, r in found.items() if name.startswith("per_cell/")]
    rows.sort(key=lambda r: r["per_cell"])
    heights = [scale * r["relative"] for r in rows]
    axes.bar(range(len(rows)), heights, color=["#9ecae1", "#1f6fb4", "#08457e"], width=0.6)
    for i, h in enumerate(heights):
        axes.text(i, h + 4, f"{h:.0f}", ha="center", fontsize=11, color=GREY)
    axes.set_xticks(range(len(rows)), [f"{r['per_cell']:.0f}" for r in rows], fontsize=11)
    axes.set_xlabel("particles per cell (640,000 in all)", fontsize=11)
    axes.set_title("cost against particles per cell", loc="left", fontsize=12)


def picture_of_scaling():
    found = results.rows("scaling")
    if not found:
        return
    # one measure for rows of different minutes: each was taken in turns with the same reference
    scale = statistics.median(r["reference_ns"] for r in found.values())
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.6), gridspec_kw={"width_ratios": [1.5, 1]})
    draw_size(left, found, scale)
    draw_per_cell(right, found, scale)
    for axes in (left, right):
        axes.margins(y=0.12)
        axes.set_ylim(0, None)
        axes.set_ylabel("ns per particle and step", fontsize=11)
        clean(axes, "top", "right")
        axes.grid(axis="y", color="#eeeeee")
        axes.set_axisbelow(True)
    left.set_ylim(0, 1.6 * scale)
    figure.suptitle("Quadratic APIC, double precision (lower is better)", x=0.01, ha="left", fontsize=14)
    figure.tight_layout()
    figure.savefig(PICTURES / "performance_scaling.png", dpi=110)


if __name__ == "__main__":
    PICTURES.mkdir(exist_ok=True)
    picture_of_steps()
    picture_of_scaling()
