"""Figures 6 and 9: the cavity's growth, and extreme velocities against the launch speed."""

import matplotlib.pyplot as plt
import numpy as np

import catalogue
import measures
from surfaces import describe

SHOWN, COLOURS = (100, 200, 400, 1000), ("#1f6fb4", "#2f9e44", "#e07b00", "#c92a2a")
EXTREME_TIMES = (3.0, 7.2, -12.0)  # ns; negative: the extreme from the start to then
LINEAR_STAGE = (3.0, 7.0)  # ns: after the cavity has taken off, before the wave reaches the free surface


def growth_rate(run, column="cavity_volume_um3", stage=LINEAR_STAGE):
    """Slope over the linear stage; nan if the run did not come so far."""
    t, y = run.history["time_ns"], run.history[column]
    use = (t >= stage[0] - 1e-6) & (t <= stage[1] + 1e-6)
    return float(np.polyfit(t[use], y[use], 1)[0]) if np.isfinite(y[use]).all() and use.sum() > 2 else np.nan


def converged(runs, speed, of_run):
    """A number of runs on the default scheme's meshes, as a limit."""
    meshes = runs.mesh_sequence(speed)
    return measures.converge(meshes, [of_run(runs.default(h, speed)) for h in meshes])


def draw_histories(axes, runs, column, label):
    for speed, colour in zip(SHOWN, COLOURS):
        paper, fine = runs.sides(speed)
        axes.plot(paper.history["time_ns"], paper.history[column], color=colour, ls="--", lw=1.3)
        axes.plot(fine.history["time_ns"], fine.history[column], color=colour, lw=2,
                  label=f"{speed} m/s (solid: default, {fine.config['spacing_um']:g} µm)")
    axes.plot([], [], color="grey", ls="--", label=f"dashed: paper's scheme, {runs.paper().config['spacing_um']:g} µm")
    axes.set(xlabel="time  (ns)", ylabel=label, xlim=(0, 15))
    axes.grid(alpha=0.25)


def draw_rates(axes, runs):
    speeds = np.array(catalogue.SPEEDS, float)
    paper = [growth_rate(runs.paper(s)) for s in catalogue.SPEEDS]
    ours = np.array([converged(runs, s, growth_rate)[:2] for s in catalogue.SPEEDS])
    axes.plot(speeds, paper, "s", mfc="none", color="#e07b00", label="paper's scheme")
    axes.errorbar(speeds, ours[:, 0], ours[:, 1], fmt="o", color="#1f6fb4", capsize=3, label="default scheme, converged")
    line = np.polyfit(speeds, ours[:, 0], 1)
    axes.plot(speeds, np.polyval(line, speeds), color="#1f6fb4", lw=1, label=f"straight line {line[0]:.3f} v {line[1]:+.1f}")
    axes.set(xlabel="launch speed  (m/s)", ylabel="growth rate of the volume  (µm³/ns)",
             title=f"Growth rate against speed\n(slope of the volume, {LINEAR_STAGE[0]:g} to {LINEAR_STAGE[1]:g} ns)")
    axes.legend(fontsize=8)
    axes.grid(alpha=0.25)


def draw_places(axes, runs):
    """Cavities at other heights and of another size, by the default scheme."""
    h = runs.set.places
    runs_shown = [(runs.default(h), "centre at 10 µm")]
    runs_shown += [(runs[f"default_centre{z}"], f"centre at {z} µm") for z in catalogue.CENTRES]
    runs_shown += [(runs[f"default_radius{catalogue.SMALL_RADIUS}"], f"radius {catalogue.SMALL_RADIUS} µm, centre at 10 µm")]
    for (run, label), colour in zip(runs_shown, plt.cm.viridis(np.linspace(0, 0.9, len(runs_shown)))):
        volume = run.history["cavity_volume_um3"]
        axes.plot(run.history["time_ns"], volume / volume[0], color=colour, label=label)
    axes.set(xlabel="time  (ns)", ylabel="volume / initial volume", xlim=(0, 15),
             title=f"Other places and sizes, 100 m/s\n(default scheme, {h:g} µm; free surface at 50 µm)")
    axes.legend(fontsize=8)
    axes.grid(alpha=0.25)


def growth(runs):
    figure, ((volume, width, height), (rates, both, places)) = plt.subplots(2, 3, figsize=(16, 9.6), layout="constrained")
    for axes, column, label in ((volume, "cavity_volume_um3", "volume  (µm³)"),
                                (width, "cavity_width_um", "width, along x  (µm)"),
                                (height, "cavity_height_um", "height, along z  (µm)")):
        draw_histories(axes, runs, column, label)
        axes.set_title(f"Cavity's {label.split()[0].rstrip(',')}")
    volume.legend(fontsize=8)
    draw_rates(rates, runs)
    for speed, colour in zip(SHOWN, COLOURS):
        h = runs.finest(speed).history
        both.plot(h["time_ns"], h["cavity_width_um"] - h["cavity_height_um"], color=colour, label=f"{speed} m/s")
    both.axhline(0, color="grey", lw=0.7)
    both.set(xlabel="time  (ns)", ylabel="width - height  (µm)", xlim=(0, 15),
             title="Across minus along the launch\n(default scheme, finest mesh)")
    both.legend(fontsize=8)
    both.grid(alpha=0.25)
    draw_places(places, runs)
    figure.suptitle("Figure 6. Growth of the cavity for four launch speeds "
                    f"(paper's scheme: {describe(runs.paper())}; default: {describe(runs.finest()).split(', ')[0]}, meshes below)")
    return figure, 75


def extreme(time, column, sign=1):
    """Of a run: a velocity at a time, or the largest until then if the time is negative."""
    def largest(run):
        return float(np.nanmax(sign * run.history[column][run.history["time_ns"] <= -time + 1e-6]))

    return largest if time < 0 else lambda run: sign * run.at(time, column)


def when(time):
    return f"at {time:g} ns" if time > 0 else f"until {-time:g} ns"


def draw_fits(axes, speeds, values, colour):
    found = measures.fits(speeds, values)
    v = np.linspace(speeds[0], speeds[-1], 200)
    for name, dashes in (("linear", ":"), ("logarithmic", "--"), ("power law", "-")):
        parameters, rms, aic = found[name]
        exponent = f" v^{parameters[1]:.2f}" if name == "power law" else ""
        axes.plot(v, measures.evaluate(name, parameters, v), dashes, color=colour, lw=1,
                  label=f"{name}{exponent}: rms {rms:.0f} m/s, AIC +{aic:.0f}")


def draw_extremes(axes, runs, time, single, mean, sign, title):
    speeds = np.array(catalogue.SPEEDS, float)
    paper = [extreme(time, single, sign)(runs.paper(s)) for s in catalogue.SPEEDS]
    ours = np.array([converged(runs, s, extreme(time, mean, sign))[:2] for s in catalogue.SPEEDS])
    axes.plot(speeds, paper, "s", mfc="none", color="#e07b00", label="paper's scheme: a single particle")
    draw_fits(axes, speeds, paper, "#e07b00")
    axes.errorbar(speeds, ours[:, 0], ours[:, 1], fmt="o", color="#1f6fb4", capsize=3,
                  label="default scheme, converged: mean of 12.5 µm³")
    draw_fits(axes, speeds, ours[:, 0], "#1f6fb4")
    axes.set(xlabel="launch speed  (m/s)", ylabel="m/s", title=title, ylim=(0, None))
    axes.legend(fontsize=8)
    axes.grid(alpha=0.25)


def extremes(runs):
    figure, rows = plt.subplots(2, len(EXTREME_TIMES), figsize=(18, 10.6), layout="constrained")
    for axes, time in zip(rows.T, EXTREME_TIMES):
        draw_extremes(axes[0], runs, time, "vz_max_m_s", "vz_high_m_s", 1, f"Largest v_z {when(time)}")
        draw_extremes(axes[1], runs, time, "vz_min_m_s", "vz_low_m_s", -1, f"Largest downward speed, -v_z, {when(time)}")
    figure.suptitle("Figure 9. Extreme velocities against the launch speed, with least-squares fits "
                    "(AIC: above the best of the three; 0 is best)")
    return figure, 75
