#!/usr/bin/python3
"""Draws what plate_impact has written: the computed profiles and the exact ones.

plot_plate_impact.py [DIR]      reads DIR/plate_impact.csv and DIR/plate_impact_exact.csv, writes DIR/plate_impact.png

DIR is where plate_impact ran, by default the present one. Needs numpy and matplotlib.
"""

import pathlib
import sys

try:
    import numpy as np
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    print(f"no picture: {error} (Debian: apt install python3-matplotlib)", file=sys.stderr)
    sys.exit(1)

FLYER, TARGET, EXACT, GREY = "#1f6fb4", "#d9730d", "black", "#777777"
PANELS = [("sigma_gpa", -1, "compressive stress  $-\\sigma_{zz}$  (GPa)", "{:.2f} GPa"),
          ("v_m_s", 1, "velocity  (m/s)", "{:.0f} m/s"),
          ("p_gpa", 1, "pressure  P  (GPa)", "{:.2f} GPa"),
          ("t_k", 1, "temperature  T  (K)", "{:.0f} K")]


def read(path):
    table = np.genfromtxt(path, delimiter=",", names=True)
    return table[table["flyer"] == 1], table[table["flyer"] == 0]


def plateau(stretches, flyer):
    """The stretch between the interface and the shock."""
    return stretches[-1 if flyer else 0]


def draw_scene(axes, exact):
    """The two plates, darker where the stress is larger; their fronts, and which way all of them move."""
    flyer, target = exact
    largest = np.abs(flyer["sigma_gpa"]).max()
    for plate, colour in ((flyer, FLYER), (target, TARGET)):
        for s in plate:
            loud = 0.15 + 0.6 * abs(s["sigma_gpa"]) / largest
            axes.axvspan(s["from_mm"], s["to_mm"], color=colour, alpha=loud, lw=0)
            if s["to_mm"] - s["from_mm"] > 0.5:
                speed = f"{s['v_m_s']:.0f} m/s" + (" →" if abs(s["v_m_s"]) > 0.5 else "")
                axes.text(0.5 * (s["from_mm"] + s["to_mm"]), 0.5, speed, ha="center", va="center", fontsize=9,
                          color="white" if loud > 0.5 else "black")
    above = dict(y=1.12, va="bottom", fontsize=9)
    below = dict(y=-0.12, va="top", fontsize=11)
    axes.text(x=plateau(flyer, True)["from_mm"], s="← shock", ha="left", **above)
    axes.text(x=plateau(target, False)["to_mm"], s="shock →", ha="right", **above)
    if len(flyer) == 3:  # not so where the shock is overdriven, or the whole wave elastic
        axes.text(x=flyer["to_mm"][0], s="← elastic", ha="right", **above)
    if len(target) == 3:
        axes.text(x=target["from_mm"][-1], s="elastic →", ha="left", **above)
    axes.text(x=flyer["from_mm"][0], s="aluminium flyer", color=FLYER, ha="left", weight="bold", **below)
    axes.text(x=target["to_mm"][-1], s="copper target", color=TARGET, ha="right", weight="bold", **below)
    axes.text(x=target["from_mm"][0], s="interface", ha="center", **below)
    axes.set_ylim(0, 1)
    axes.axis("off")


def draw_panel(axes, computed, exact, name, sign, label, form):
    for plate, stretches, colour, who in zip(computed, exact, (FLYER, TARGET), ("aluminium", "copper")):
        axes.plot(plate["z_mm"], sign * plate[name], "o", ms=2.2, color=colour, alpha=0.6, mew=0,
                  label=f"mote, {who} particles", zorder=2)
    both = np.concatenate(exact)
    z = np.column_stack([both["from_mm"], both["to_mm"]]).ravel()
    axes.plot(z, sign * np.repeat(both[name], 2), color=EXACT, lw=1.1, label="exact", zorder=3)
    for front in both["to_mm"][:-1]:
        axes.axvline(front, color=GREY, lw=0.7, ls=":", zorder=1)
    for stretches, is_flyer in ((exact[0], True), (exact[1], False)):
        s = plateau(stretches, is_flyer)
        value = sign * s[name]
        axes.annotate(form.format(value), (0.5 * (s["from_mm"] + s["to_mm"]), value), (0, -7),
                      textcoords="offset points", ha="center", va="top", fontsize=9)
    axes.set_ylabel(label)
    axes.set_xlim(z[0], z[-1])
    axes.grid(alpha=0.2)


def draw(directory):
    computed = read(directory / "plate_impact.csv")
    exact = read(directory / "plate_impact_exact.csv")
    figure = plt.figure(figsize=(13, 8.8))
    grid = figure.add_gridspec(3, 2, height_ratios=(0.16, 1, 1), left=0.06, right=0.985, top=0.895, bottom=0.065,
                               hspace=0.2, wspace=0.15)
    panels = [figure.add_subplot(grid[1 + i // 2, i % 2]) for i in range(4)]
    for axes, panel in zip(panels, PANELS):
        draw_panel(axes, computed, exact, *panel)
    for column in (0, 1):
        draw_scene(figure.add_subplot(grid[0, column], sharex=panels[column]), exact)
    for axes in panels[2:]:
        axes.set_xlabel("z  (mm)")
    panels[0].legend(fontsize=9, loc="lower center", markerscale=3)
    time, speed = exact[0]["time_us"][0], exact[0]["v_m_s"][0]
    figure.suptitle(f"Plate impact: aluminium at {speed:g} m/s has hit copper at rest {time:g} µs ago", fontsize=14)
    file = directory / "plate_impact.png"
    figure.savefig(file, dpi=100)
    plt.close(figure)
    return file


def main():
    if len(sys.argv) > 2 or (len(sys.argv) == 2 and sys.argv[1].startswith("-")):
        print(__doc__, file=sys.stderr)
        return 1
    try:
        print(draw(pathlib.Path(sys.argv[1] if len(sys.argv) == 2 else ".")))
    except (OSError, ValueError) as error:
        print(f"no picture: {error}; has plate_impact run here?", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
