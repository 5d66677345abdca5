"""Figures 1, 3, 4 and 5: surfaces in space."""

import matplotlib.pyplot as plt

import scenes

NAMES = ("paper's scheme", "default scheme")


def describe(run):
    c = run.config
    blend = "" if c["flip_blend"] in (None, 1) else f" {c['flip_blend']:g}"
    return f"{c['shape']} {c['transfer'].upper()}{blend} {c['update'].upper()}, mesh {c['spacing_um']:g} µm"


def side_titles(rows, runs, offset=-0.04):
    for axes, name, run in zip(rows, NAMES, runs):
        axes.text(offset, 0.5, f"{name}\n{describe(run)}", transform=axes.transAxes, rotation=90, ha="center", va="center",
                  fontsize=11)


def stride(run, wanted):
    """Nodes to skip so that surfaces are drawn on a mesh no finer than wanted, um."""
    return max(1, int(round(wanted / run.config["spacing_um"])))


def velocity(runs, times=(0.8, 1.2, 2.0, 3.0), limit=300):
    sides = runs.sides()
    figure, rows = plt.subplots(2, len(times), figsize=(15, 8.4), layout="constrained")
    for row, run in zip(rows, sides):
        for axes, time in zip(row, times):
            half = scenes.part(run.grid(time, stride(run, 0.5)), 0, 24)
            speed = dict(field="vz", limits=(-limit, limit))
            things = [scenes.actor(scenes.face(half, "vz"), smooth=False, **speed),
                      scenes.actor(scenes.level_surface(half, "vz", 0), (0.95, 0.75, 0.1), 0.55),
                      scenes.actor(scenes.cavity_surface(half, run.config["centre_z_um"]), (0.25, 0.25, 0.25), 0.35),
                      scenes.actor(scenes.box(half), (0, 0, 0), smooth=False)]
            axes.imshow(scenes.render(things, (6, 0, 11.5), 17.5, (1, -0.38, 0.32)))
            low, high = run.at(time, "vz_min_m_s"), run.at(time, "vz_max_m_s")
            axes.set_title(f"{time:g} ns: particles {low:.0f} to {high:.0f} m/s", fontsize=11)
            axes.axis("off")
    side_titles(rows[:, 0], sides)
    colours = plt.cm.ScalarMappable(plt.Normalize(-limit, limit), "RdBu_r")
    figure.colorbar(colours, ax=rows, label="v_z on the plane x = 0  (m/s)", fraction=0.015, extend="both")
    figure.suptitle(f"Figure 1. Launch at {sides[0].config['speed_m_s']:g} m/s away from the wall (bottom): v_z on the plane "
                    "x = 0, and in front of it the surface v_z = 0 (yellow) and the cavity (grey). Box: 40 µm wide, 24 µm high")
    return figure, 80


def isobars(runs, number, time, levels, extra):
    sides = runs.sides()
    figure, rows = plt.subplots(2, len(levels), figsize=(17, 6.6), layout="constrained")
    for row, run in zip(rows, sides):
        grid = scenes.tiled(scenes.part(run.grid(time, stride(run, 0.5)), z_max=30))
        holes = scenes.all_surfaces(grid)
        for axes, level in zip(row, levels):
            things = [scenes.actor(scenes.level_surface(grid, "p", level), (0.30, 0.55, 0.85)),
                      scenes.actor(holes, (0.85, 0.45, 0.15), 0.9), scenes.actor(scenes.box(grid), (0, 0, 0), smooth=False)]
            axes.imshow(scenes.render(things, (20, 20, 13), 47, (0.55, -1, 0.75), (420, 400)))
            axes.set_title(f"{level:g} MPa", fontsize=12)
            axes.axis("off")
    side_titles(rows[:, 0], sides)
    figure.suptitle(f"Figure {number}. Isobars (blue) at {time:g} ns around the cavity (orange) and three of its periodic "
                    f"images, launch at {sides[0].config['speed_m_s']:g} m/s.\nShown: 80 x 80 µm, lowest 30 µm above the wall."
                    + extra)
    return figure, 75


def isobars_9(runs):
    return isobars(runs, 3, 9, (-300, -350, -400, -450, -500, -550), " Negative: tension")


def isobars_11(runs):
    return isobars(runs, 4, 11, (0, -50, -100, -150, -200, -250), " Negative: tension")


def temperature(runs, time=6, levels=(310, 320, 330, 340)):
    sides = runs.sides()
    figure, rows = plt.subplots(2, len(levels), figsize=(14, 7.4), layout="constrained")
    for row, run in zip(rows, sides):
        grid = scenes.part(run.grid(time, stride(run, 0.25)), z_max=30)
        hole = scenes.cavity_surface(grid, run.config["centre_z_um"])
        for axes, level in zip(row, levels):
            things = [scenes.actor(hole, (0.6, 0.6, 0.6), 0.45), scenes.actor(scenes.box(grid), (0, 0, 0), smooth=False)]
            hot = scenes.level_surface(grid, "t", level)
            if hot.GetNumberOfPoints():
                things.append(scenes.actor(hot, plt.get_cmap("autumn_r")((level - 305) / 40)[:3]))
            axes.imshow(scenes.render(things, (0, 0, 14), 22, (0.6, -1, 0.4)))
            hot_volume = float((grid.solid & (grid.t >= level)).sum()) * grid.h ** 3
            axes.set_title(f"{level} K: {hot_volume:.0f} µm³ hotter", fontsize=11)
            axes.axis("off")
    side_titles(rows[:, 0], sides)
    figure.suptitle(f"Figure 5. Surfaces of constant temperature at {time:g} ns (start: 300 K) around the cavity (grey), "
                    f"launch at {sides[0].config['speed_m_s']:g} m/s. Box: 40 x 40 x 30 µm above the wall")
    return figure, 80
