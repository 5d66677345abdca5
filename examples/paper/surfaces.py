"""Figures 1, 3, 4 and 5: surfaces in space."""

import matplotlib.pyplot as plt

import scenes

NAMES = ("paper's scheme", "default scheme")
TRANSFERS = {"aflip": "AffineFlip"}
STEEP = 5.0  # m/s per um: where v_z changes less from place to place, its sign is chance


def describe(run):
    c = run.config
    blend = "" if c["flip_blend"] in (None, 1) else f" {c['flip_blend']:g}"
    transfer = TRANSFERS.get(c["transfer"], c["transfer"].upper())
    return f"{c['shape']} {transfer}{blend} {c['update'].upper()}, mesh {c['spacing_um']:g} µm"


def side_titles(rows, runs, offset=-0.01):
    for axes, name, run in zip(rows, NAMES, runs):
        axes.text(offset, 0.5, f"{name}\n{describe(run).replace(', ', chr(10))}", transform=axes.transAxes, rotation=90,
                  ha="right", va="center", multialignment="center", fontsize=11, linespacing=1.3)


def stride(run, wanted):
    """Nodes to skip so that surfaces are drawn on a mesh no finer than wanted, um."""
    return max(1, int(round(wanted / run.config["spacing_um"])))


def velocity(runs, times=(0.8, 1.2, 2.0, 3.0), limit=300):
    sides = runs.sides()
    figure, rows = plt.subplots(2, len(times), figsize=(16, 7.4), layout="constrained")
    for row, run in zip(rows, sides):
        for axes, time in zip(row, times):
            half = scenes.part(run.grid(time, stride(run, 0.5)), 0, 24)
            speed = dict(field="vz", limits=(-limit, limit))
            things = [scenes.actor(scenes.face(half, "vz"), smooth=False, **speed),
                      scenes.actor(scenes.level_surface(half, "vz", 0, STEEP), (1.0, 0.85, 0.2), 0.6),
                      scenes.actor(scenes.cavity_surface(half, run.config["centre_z_um"]), (0.55, 0.55, 0.55)),
                      scenes.actor(scenes.box(half), (0, 0, 0), smooth=False)]
            axes.imshow(scenes.render(things, (10, 0, 12), 17, (1, -0.38, 0.32), (780, 560)))
            low, high = run.at(time, "vz_min_m_s"), run.at(time, "vz_max_m_s")
            axes.set_title(f"{time:g} ns: particles {low:.0f} to {high:.0f} m/s", fontsize=12)
            axes.axis("off")
    side_titles(rows[:, 0], sides)
    colours = plt.cm.ScalarMappable(plt.Normalize(-limit, limit), "RdBu_r")
    figure.colorbar(colours, ax=rows, label="v_z on the plane x = 0  (m/s)", fraction=0.015, extend="both")
    figure.suptitle(f"Figure 1. Launch at {sides[0].config['speed_m_s']:g} m/s away from the wall below: v_z on the plane x = 0; "
                    "in front of it the cavity (grey) and the surface v_z = 0 (yellow),\ndrawn where v_z changes by more than "
                    f"{STEEP:g} m/s per µm: elsewhere behind the wave v_z is 0 but for noise. Box: 40 µm wide, 24 µm high, half as "
                    "deep")
    return figure, 75


def isobars(runs, number, time, levels):
    sides = runs.sides()
    figure, rows = plt.subplots(2, len(levels), figsize=(19, 6.2), layout="constrained")
    for row, run in zip(rows, sides):
        grid = scenes.tiled(scenes.part(run.grid(time, stride(run, 0.5)), z_max=25))
        holes = scenes.all_surfaces(grid)
        for axes, level in zip(row, levels):
            things = [scenes.actor(scenes.level_surface(grid, "p", level), (0.30, 0.55, 0.95), 0.55),
                      scenes.actor(holes, (0.95, 0.5, 0.15)), scenes.actor(scenes.box(grid), (0, 0, 0), smooth=False)]
            axes.imshow(scenes.render(things, (20, 20, 12.5), 43, (0.55, -1, 0.75), (560, 410)))
            axes.set_title(f"{level:g} MPa", fontsize=13)
            axes.axis("off")
    side_titles(rows[:, 0], sides)
    figure.suptitle(f"Figure {number}. Isobars (blue; negative: tension) at {time:g} ns around the cavity (orange) and three of its "
                    f"periodic images, launch at {sides[0].config['speed_m_s']:g} m/s. Box: 80 x 80 µm, the lowest 25 µm above "
                    "the wall", fontsize=14)
    return figure, 75


def isobars_9(runs):
    return isobars(runs, 3, 9, (-300, -350, -400, -450, -500, -550))


def isobars_11(runs):
    return isobars(runs, 4, 11, (0, -50, -100, -150, -200, -250))


def temperature(runs, time=6, levels=(310, 320, 330, 340)):
    sides = runs.sides()
    figure, rows = plt.subplots(2, len(levels), figsize=(13, 6.9), layout="constrained")
    for row, run in zip(rows, sides):
        grid = scenes.part(run.grid(time, stride(run, 0.25)), z_max=24)
        hole = scenes.cavity_surface(grid, run.config["centre_z_um"])
        for axes, level in zip(row, levels):
            things = [scenes.actor(hole, (0.75, 0.75, 0.75), 0.5)]
            hot = scenes.level_surface(grid, "t", level)
            if hot.GetNumberOfPoints():
                things.append(scenes.actor(hot, plt.get_cmap("autumn_r")((level - 305) / 40)[:3]))
            axes.imshow(scenes.render(things, (0, 0, 8.5), 11, (0.6, -1, -0.25), (560, 480)))
            axes.plot([30, 30 + 5 * 480 / 22], [20, 20], color="black", lw=3)
            axes.text(30 + 2.5 * 480 / 22, 30, "5 µm", ha="center", va="top")
            hot_volume = float((grid.solid & (grid.t >= level)).sum()) * grid.h ** 3
            axes.set_title(f"{level} K: {hot_volume:.0f} µm³ are hotter" if hot_volume else f"{level} K: nowhere", fontsize=12)
            axes.axis("off")
    side_titles(rows[:, 0], sides)
    hottest = ", ".join(f"{run.at(time, 't_max_k'):.0f} K ({name})" for run, name in zip(sides, NAMES))
    figure.suptitle(f"Figure 5. Surfaces of constant temperature at {time:g} ns (start: 300 K; colours by level) around the cavity "
                    f"(grey),\nlaunch at {sides[0].config['speed_m_s']:g} m/s, seen from below and the side. "
                    f"Flat pieces below: warm metal at the wall.\nHottest particle: {hottest}")
    return figure, 80
