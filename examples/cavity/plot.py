#!/usr/bin/python3
"""Turns the directory of a cavity run into pictures.

plot.py DIR      writes DIR/pictures/{histories,axis,cut,surface}.png

Needs numpy and matplotlib; the cut and the surface need VTK's Python module, the surface a display or xvfb-run too.
What cannot be made is left out, with the reason. Exit code: 0 all made, 3 some were left out, 1 none could be made.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys

try:
    import numpy as np
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError as error:
    print(f"no pictures: {error} (Debian: apt install python3-matplotlib python3-vtk9 xvfb)", file=sys.stderr)
    sys.exit(1)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
BLUE, ORANGE, GREEN, RED, GREY = "#1f6fb4", "#e07b00", "#2f9e44", "#c92a2a", "#777777"
PAPER = {"min": [(2, -230), (3, -300), (7.2, -325)], "max": [(7.2, 430)]}  # m/s at ns, Xu et al., launch at 100 m/s


class LeftOut(Exception):
    """A picture cannot be made; the text says why."""


def read_csv(path):
    """Column name -> numpy array."""
    if not path.exists():
        raise LeftOut(f"{path} is missing")
    table = np.genfromtxt(path, delimiter=",", names=True)
    if table.size < 2:
        raise LeftOut(f"{path} has no rows to draw")
    return {name: table[name] for name in table.dtype.names}


def describe(config):
    """One line about the run."""
    blend = "" if config["flip_blend"] in (None, 1) else f" {config['flip_blend']}"
    blend += "" if config.get("order") is None else f"({config['order']})"
    return (f"launch {config['speed_m_s']:g} m/s, mesh {config['spacing_um']:g} µm, {config['shape']}, "
            f"{config['transfer'].upper()}{blend}, {config['update'].upper()}, {config['fill']} fill")


def is_papers_scene(config):
    return (config["speed_m_s"], config["radius_um"], config["centre_z_um"]) == (100, 5, 10)


def draw_velocity(axes, h, config):
    t = h["time_ns"]
    axes.plot(t, h["vz_max_m_s"], color=RED, label="fastest particle")
    axes.plot(t, h["vz_high_m_s"], color=RED, ls="--", label="fastest 12.5 µm³")
    axes.plot(t, h["vz_max_grid_m_s"], color=RED, ls=":", label="fastest node")
    axes.plot(t, h["vz_min_m_s"], color=BLUE, label="slowest particle")
    axes.plot(t, h["vz_low_m_s"], color=BLUE, ls="--", label="slowest 12.5 µm³")
    axes.plot(t, h["vz_min_grid_m_s"], color=BLUE, ls=":", label="slowest node")
    if is_papers_scene(config):
        points = [p for p in PAPER["min"] + PAPER["max"] if p[0] <= t[-1] + 1e-6]
        axes.plot(*zip(*points), "kD", ms=5, label="Xu et al. (the paper)", clip_on=False, zorder=5) if points else None
    axes.set(title="Velocity along z: extremes", ylabel="v_z  (m/s)")
    axes.legend(fontsize=7, ncol=2)


def draw_cavity(axes, h):
    t = h["time_ns"]
    if not np.isfinite(h["cavity_volume_um3"]).any():
        axes.text(0.5, 0.5, "no cavity was measured", ha="center", transform=axes.transAxes)
        axes.set(title="Cavity")
        return
    axes.plot(t, h["cavity_volume_um3"], color=GREEN, label="volume")
    axes.set(title="Cavity: volume (left), width and height (right)", ylabel="volume  (µm³)")
    right = axes.twinx()
    right.plot(t, h["cavity_width_um"], color=ORANGE, label="width")
    right.plot(t, h["cavity_height_um"], color=BLUE, ls="--", label="height")
    right.set_ylabel("extent  (µm)")
    lines = axes.get_lines() + right.get_lines()
    axes.legend(lines, [line.get_label() for line in lines], fontsize=8, loc="upper left")


def draw_energies(axes, h):
    parts = [("kinetic_j", "kinetic", BLUE), ("elastic_j", "elastic", GREEN), ("plastic_j", "plastic", ORANGE),
             ("viscous_j", "viscous", RED), ("transfer_loss_j", "lost in transfers and at the wall", GREY)]
    parts = [p for p in parts if np.abs(h[p[0]]).max() > 0]
    axes.stackplot(h["time_ns"], *[1e6 * h[name] for name, _, _ in parts], labels=[p[1] for p in parts],
                   colors=[p[2] for p in parts], alpha=0.75)
    total = 1e6 * sum(h[name] for name in ("kinetic_j", "elastic_j", "plastic_j", "viscous_j"))
    axes.plot(h["time_ns"], total, color="black", lw=1.2, label="sum of energies")
    axes.set(title="Energies, stacked (whole body)", ylabel="energy  (µJ)", ylim=(0, None))
    axes.legend(fontsize=7, loc="lower left")


def draw_histories(run, config, file):
    h = read_csv(run / "history.csv")
    t = h["time_ns"]
    figure, ((v, cavity, energy), (p, temperature, error)) = plt.subplots(2, 3, figsize=(16, 8.6), sharex=True)
    draw_velocity(v, h, config)
    draw_cavity(cavity, h)
    draw_energies(energy, h)
    p.plot(t, h["p_max_mpa"] / 1000, color=RED, label="largest")
    p.plot(t, h["p_min_mpa"] / 1000, color=BLUE, label="smallest (tension)")
    p.set(title="Pressure: extremes over particles", ylabel="P  (GPa)")
    p.legend(fontsize=8)
    temperature.plot(t, h["t_max_k"], color=RED)
    temperature.set(title="Largest temperature of a particle", ylabel="T  (K)")
    error.plot(t, 100 * h["energy_error"], color="black", label="change of the sum of energies")
    error.plot(t, -100 * h["transfer_loss_j"] / max(h["kinetic_j"][0], 1e-300), color=GREY, ls="--",
               label="known losses (transfers, wall)")
    error.set(title="Energy balance", ylabel="% of the initial kinetic energy")
    error.legend(fontsize=8)
    for axes in (v, cavity, energy, p, temperature, error):
        axes.grid(alpha=0.25)
        axes.margins(x=0)
        axes.set_xlabel("time  (ns)")
    figure.suptitle("Cavity in aluminium: histories — " + describe(config))
    save(figure, file)


def bridged(column, widest=3):
    """A column with gaps of a few bins closed by interpolation: bins can be finer than particles are apart."""
    full = np.flatnonzero(np.isfinite(column))
    for a, b in zip(full[:-1], full[1:]):
        if 1 < b - a <= widest:
            column[a:b] = np.interp(np.arange(a, b), (a, b), (column[a], column[b]))
    return column


def draw_axis(run, config, file):
    a = read_csv(run / "axis.csv")
    times, heights = np.unique(a["time_ns"]), np.unique(a["z_um"])
    if len(times) < 2:
        raise LeftOut("axis.csv has fewer than two times")
    figure, panels = plt.subplots(2, 2, figsize=(15, 10), width_ratios=(1, 1.15))
    step = np.diff(heights).min()
    heights = heights[0] + step * np.arange(round((heights[-1] - heights[0]) / step) + 1)
    fields = [("vz_m_s", 1, "v_z  (m/s)"), ("p_mpa", 1e-3, "P  (GPa)")]
    for (diagram, lines), (name, scale, label) in zip(panels, fields):
        table = np.full((len(heights), len(times)), np.nan)
        rows = np.round((a["z_um"] - heights[0]) / step).astype(int)
        table[rows, np.searchsorted(times, a["time_ns"])] = a[name] * scale
        table = np.apply_along_axis(bridged, 0, table)
        limit = float(f"{np.nanpercentile(np.abs(table), 99.5):.1g}") or 1
        mesh = diagram.contourf(times, heights, table,
                                levels=np.linspace(-limit, limit, 38),  # none at 0 or at the
                                cmap="RdBu_r", extend="both")  # launch speed, where round-off would show
        diagram.plot(times, np.full(len(times), heights[-1] + 2 * step), "kv", ms=4, clip_on=False)
        diagram.set_facecolor("#dddddd")
        diagram.set(xlabel="time  (ns)", ylabel="z  (µm)",
                    title=f"{label.split()[0]} on the axis (grey: cavity; ▼ frames)")
        figure.colorbar(mesh, ax=diagram, label=label, ticks=np.linspace(-limit, limit, 9))
        shown = np.unique(np.linspace(0, len(times) - 1, 7).astype(int))
        for k, i in enumerate(shown):
            lines.plot(heights, table[:, i], color=plt.cm.viridis(k / max(len(shown) - 1, 1) * 0.92), lw=1.4,
                       label=f"{times[i]:.2f} ns")
        lines.set(xlabel="z  (µm)", ylabel=label, title=f"{label.split()[0]} on the axis at frame times")
        lines.grid(alpha=0.25)
        lines.legend(fontsize=8)
    figure.suptitle("Profile on the axis |x|, |y| < h — " + describe(config))
    save(figure, file)


def save(figure, file):
    figure.tight_layout()
    figure.savefig(file, dpi=110)
    plt.close(figure)


def draw_cut(run, config, file):
    frames = import_frames()
    frames.draw_cut(run, describe(config), file)


def draw_surface(run, config, file):
    """VTK renders in a process of its own, since without a display it ends the process rather than complain."""
    import_frames()
    if config["radius_um"] == 0:
        raise LeftOut("the run has no cavity")
    command = [sys.executable, str(pathlib.Path(__file__).resolve().parent / "plot_frames.py"), str(run),
               describe(config), str(config["centre_z_um"]), str(file)]
    if not os.environ.get("DISPLAY"):
        if not shutil.which("xvfb-run"):
            raise LeftOut("there is neither a display nor xvfb-run (Debian: apt install xvfb)")
        command = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24"] + command
    done = subprocess.run(command, capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        raise LeftOut((done.stderr.strip() or f"exit code {done.returncode}").splitlines()[-1])


def import_frames():
    try:
        import plot_frames
    except ImportError as error:
        raise LeftOut(f"{error} (Debian: apt install python3-vtk9)") from None
    return plot_frames


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 1
    run = pathlib.Path(sys.argv[1])
    try:
        config = json.loads((run / "summary.json").read_text())["configuration"]
    except (OSError, ValueError, KeyError) as error:
        print(f"no pictures: {run}/summary.json cannot be read ({error}); is it a finished run?", file=sys.stderr)
        return 1
    (run / "pictures").mkdir(exist_ok=True)
    made = 0
    pictures = {"histories": draw_histories, "axis": draw_axis, "cut": draw_cut, "surface": draw_surface}
    for name, draw in pictures.items():
        file = run / "pictures" / f"{name}.png"
        try:
            draw(run, config, file)
            made += 1
            print(file)
        except (LeftOut, subprocess.TimeoutExpired, OSError, ValueError) as reason:
            print(f"{file} is left out: {reason}", file=sys.stderr)
    return 0 if made == len(pictures) else 3 if made else 1


if __name__ == "__main__":
    sys.exit(main())
