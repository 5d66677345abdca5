"""Figures 2, 7 and 8: cuts through the axis, and profiles along it."""

import sys
import pathlib

import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cavity"))
from plot_frames import extended  # noqa: E402
from surfaces import NAMES, describe, stride  # noqa: E402

FIELDS = {"p": ("pressure", "MPa", "RdBu_r"), "vz": ("v_z", "m/s", "RdBu_r"), "rho": ("density", "kg/m³", "viridis"),
          "t": ("temperature", "K", "inferno")}
COLOURS = ("#e07b00", "#1f6fb4")


def draw(axes, grid, name, limits):
    """The field on the plane x = 0; grey where there is no metal."""
    fraction, half = grid.rectangle(grid.fraction), 0.5 * grid.h
    axes.imshow(extended(grid.rectangle(getattr(grid, name)), fraction > 0.05), origin="lower",
                extent=(grid.y[0] - half, grid.y[-1] + half, grid.z[0] - half, grid.z[-1] + half),
                interpolation="bilinear", cmap=FIELDS[name][2], vmin=limits[0], vmax=limits[1])
    axes.contourf(grid.y, grid.z, fraction, levels=(-1, 0.5), colors=("#dddddd",))
    axes.set(facecolor="#dddddd", xlim=(grid.y[0], grid.y[-1]), ylim=(0, grid.z[-1]))


def arrows(axes, grid, every=2.5):
    """The velocity in the plane, on points some um apart."""
    step = max(1, int(round(every / grid.h)))
    solid = grid.rectangle(grid.solid)[::step, ::step]
    v, w = (grid.rectangle(a)[::step, ::step] for a in (grid.vy, grid.vz))
    y, z = np.meshgrid(grid.y[::step], grid.z[::step])
    axes.quiver(y[solid], z[solid], v[solid], w[solid], angles="xy", scale=2600, width=0.004, color="black")


def bar(figure, axes, name, limits):
    label, unit, colours = FIELDS[name]
    figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(*limits), colours), ax=axes, label=f"{label}  ({unit})",
                    fraction=0.04, aspect=35, extend="both")


def early(runs, times=(2, 3), top=26):
    sides = runs.sides()
    figure, rows = plt.subplots(len(times), 5, figsize=(19, 6.6), layout="constrained", width_ratios=(1, 1, 1, 1, 1.15))
    limits = {"p": (-2000, 2000), "vz": (-300, 300)}
    for row, time in zip(rows, times):
        for k, run in enumerate(sides):
            grid = run.grid(time, stride(run, 0.25))
            for axes, name in zip((row[k], row[2 + k]), ("p", "vz")):
                draw(axes, grid, name, limits[name])
                axes.set(ylim=(0, top), xlabel="y  (µm)", title=f"{FIELDS[name][0]}, {NAMES[k]}, {time:g} ns")
            arrows(row[k], grid)
            z, v = run.profile(time, "vz_m_s")
            z, v = with_gaps(z, v)
            row[4].plot(z, v, color=COLOURS[k], label=NAMES[k])
        row[0].set_ylabel("z  (µm)")
        row[4].axhline(0, color="grey", lw=0.7)
        row[4].set(xlabel="z  (µm)", ylabel="v_z on the axis  (m/s)", xlim=(0, top), ylim=(-330, 330),
                   title=f"v_z along the axis, {time:g} ns (gap: cavity)")
        row[4].legend(fontsize=8, loc="lower right")
        row[4].grid(alpha=0.25)
    bar(figure, rows[:, 1].tolist(), "p", limits["p"])
    bar(figure, rows[:, 3].tolist(), "vz", limits["vz"])
    figure.suptitle(f"Figure 2. Plane x = 0 through the cavity's axis, launch at {sides[0].config['speed_m_s']:g} m/s away from "
                    "the wall at z = 0: pressure with velocity arrows, and v_z\n"
                    f"(paper's scheme: {describe(sides[0])}; default: {describe(sides[1])}; grey: no metal)")
    return figure, 75


def with_gaps(z, values, widest=1.6):
    """A profile with nan where bins are missing, so that no line is drawn across the cavity."""
    places = np.flatnonzero(np.diff(z) > widest) + 1
    return np.insert(z, places, np.nan), np.insert(values, places, np.nan)


def late(runs, number, names, limits, times=(7.2, 12)):
    sides = runs.sides()
    figure, rows = plt.subplots(2, 4, figsize=(13.5, 9), layout="constrained", sharey=True)
    for row, run, side in zip(rows, sides, NAMES):
        for k, time in enumerate(times):
            grid = run.grid(time, stride(run, 0.25))
            for j, name in enumerate(names):
                axes = row[2 * j + k]
                draw(axes, grid, name, limits[name])
                values = grid.rectangle(getattr(grid, name))[grid.rectangle(grid.solid)]
                label, unit, _ = FIELDS[name]
                axes.set_title(f"{label}, {time:g} ns\n{values.min():.0f} to {values.max():.0f} {unit}", fontsize=10)
        row[0].set_ylabel(f"{side}\n{describe(run)}\n\nz  (µm)")
    for axes in rows[-1]:
        axes.set_xlabel("y  (µm)")
    for j, name in enumerate(names):
        bar(figure, rows[:, 2 * j + 1].tolist(), name, limits[name])
    fields = " and ".join(FIELDS[name][0] for name in names)
    figure.suptitle(f"Figure {number}. {fields[0].upper() + fields[1:]} on the plane x = 0 "
                    f"(wall at z = 0; grey: no metal), launch at {sides[0].config['speed_m_s']:g} m/s.\n"
                    "Titles give the least and the greatest value on the plane.")
    return figure, 75


def density_and_pressure(runs):
    return late(runs, 7, ("rho", "p"), {"rho": (2650, 2730), "p": (-1500, 1500)})


def temperature_and_velocity(runs):
    return late(runs, 8, ("t", "vz"), {"t": (285, 365), "vz": (-300, 300)})
