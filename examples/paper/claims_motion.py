"""Claims about velocities and waves."""

import numpy as np

import catalogue
import curves
import measures
from rows import ARTEFACT, HOLDS, NOT, QUALITATIVE, Row, converged, in_full, judge, number, of_default, spread


def at(time, column):
    return lambda run: run.at(time, column)


def front(run, time=0.8):
    """Height at which v_z on the axis first exceeds half the launch speed, and the range of v_z a micrometre below."""
    grid = run.grid(time)
    v = grid.vz[:, int(np.argmin(np.abs(grid.y))), int(np.argmin(np.abs(grid.x)))]
    half = 0.5 * run.config["speed_m_s"]
    k = int(np.argmax(v > half))
    z = grid.z[k - 1] + (half - v[k - 1]) / (v[k] - v[k - 1]) * grid.h
    behind = v[(grid.z > 0) & (grid.z < z - 1)]
    return float(z), float(behind.min()), float(behind.max())


def early_front(runs):
    sides = [front(run) for run in runs.sides()]
    said = [f"z = {z:.2f} µm; behind it v_z from {low:.0f} to {high:.0f} m/s" for z, low, high in sides]
    below = runs.paper().config["centre_z_um"] - runs.paper().config["radius_um"]
    return Row("At 0.8 ns the surface v_z = 0 lies below the cavity",
               "v_z on the axis: where it passes half the launch speed (behind the wave v_z vanishes, so that the place of "
               "v_z = 0 itself is ill-defined); the cavity begins at 5 µm", "below the cavity", said[0],
               f"z = {of_default(runs, lambda run: front(run)[0], 2, unit=' µm')}; {said[1].split('; ')[1]}",
               HOLDS if all(0 < side[0] < below for side in sides) else NOT)


def extreme(runs, claim, time, side, paper):
    """Largest or smallest v_z: single particles, 12.5 um^3, nodes."""
    single, mean, grid = {"min": ("vz_min_m_s", "vz_low_m_s", "vz_min_grid_m_s"),
                          "max": ("vz_max_m_s", "vz_high_m_s", "vz_max_grid_m_s")}[side]
    p = runs.paper()
    limit = converged(runs, at(time, mean))
    _, jitter = spread(runs, at(time, single))
    word = {"min": "smallest", "max": "largest"}[side]
    return Row(claim, f"{word} v_z of a particle at {time:g} ns; converged: mean of the {word} 12.5 µm³", f"{paper} m/s",
               f"{number(p.at(time, single))} (jittered lattices: ± {jitter:.0f}); 12.5 µm³ {number(p.at(time, mean))}, nodes "
               f"{number(p.at(time, grid))}",
               f"{in_full(limit, runs.mesh_sequence())}; single particle on the finest mesh "
               f"{number(runs.finest().at(time, single))}",
               judge(paper, p.at(time, single), limit.value, limit.bar))


def upward(runs):
    v0 = runs.paper().config["speed_m_s"]
    p, limit = runs.paper(), converged(runs, at(3, "vz_high_m_s"))
    excess = limit.value - v0
    if excess - limit.bar > 0.02 * v0:
        verdict = HOLDS
    elif excess > limit.bar:
        verdict = f"{QUALITATIVE}: some does, but by {excess:.0f} m/s only"
    else:
        verdict = ARTEFACT if p.at(3, "vz_max_m_s") > 1.02 * v0 else NOT
    return Row("At 3 ns some material moves up faster than it was launched, above 100 m/s",
               "largest v_z of a particle at 3 ns; converged: mean of the fastest 12.5 µm³", "> 100 m/s",
               f"{number(p.at(3, 'vz_max_m_s'))}; 12.5 µm³ {number(p.at(3, 'vz_high_m_s'))}", 
               in_full(limit, runs.mesh_sequence()), verdict)


def top_speed(run):
    """Times and v_z of the topmost micrometre of the axis."""
    times = np.unique(run.axis["time_ns"])
    v = []
    for t in times:
        rows = np.abs(run.axis["time_ns"] - t) < 1e-6
        z = run.axis["z_um"][rows]
        v.append(run.axis["vz_m_s"][rows][z > z.max() - 1].mean())
    return times, np.array(v)


def arrival(run, change):
    """When v_z of the topmost micrometre has changed by so much, ns."""
    t, v = top_speed(run)
    moved = np.abs(v - v[0]) >= change
    if not moved.any():
        return np.nan
    k = int(np.argmax(moved))
    a, b = abs(v[k - 1] - v[0]), abs(v[k] - v[0])
    return float(t[k - 1] + (change - a) / (b - a) * (t[k] - t[k - 1]))


def free_surface(runs):
    said = []
    for run in runs.sides():
        t, v = top_speed(run)
        said.append(f"v_z of the topmost µm at 7.2 ns {np.interp(7.2, t, v):.2f} m/s; changed by 1 m/s at {arrival(run, 1):.2f} ns, "
                    f"by 15 m/s (half of the elastic wave's jump) at {arrival(run, 15):.2f} ns, by 100 m/s (half of the "
                    f"plastic wave's) at {arrival(run, 100):.2f} ns")
    limit = converged(runs, lambda run: arrival(run, 15))
    verdict = HOLDS if arrival(runs.finest(), 15) <= 7.2 else (
        f"{QUALITATIVE}: the elastic wave comes {limit.value - 7.2:.1f} ns later" +
        ("; at 7.2 ns only the paper's scheme has a numerical foot of it" if arrival(runs.paper(), 1) <= 7.2 else ""))
    return Row("At 7.2 ns the wave reaches the free surface",
               "v_z of the topmost micrometre on the axis; exact: the elastic front needs 50 µm / 6437 m/s = 7.77 ns, the "
               "plastic one 50 µm / 5350 m/s = 9.35 ns", "7.2 ns", said[0],
               f"elastic wave at {in_full(limit, runs.mesh_sequence(), 2, ' ns')}; finest mesh: {said[1]}",
               verdict)


def valley(run, time=7.2):
    """The least v_z on the axis between the cavity's upper face and the wave."""
    z, v = run.profile(time, "vz_m_s")
    gap = np.flatnonzero(np.diff(z) > 1.6)
    above = z > z[gap[-1] + 1] + 1 if gap.size else z > run.config["centre_z_um"]
    k = int(np.argmin(np.where(above & (z < 45), v, np.inf)))
    return float(v[k]), float(z[k])


def valley_row(runs, paper=6):
    p = valley(runs.paper())
    limit = converged(runs, lambda run: valley(run)[0])
    close = abs(limit.value - paper) <= max(10, limit.bar)
    return Row("At 7.2 ns a valley of 6 m/s lies between", "least v_z on the axis between the cavity's upper face and the wave",
               f"{paper} m/s", f"{p[0]:.1f} m/s at z = {p[1]:.1f} µm",
               f"{in_full(limit, runs.mesh_sequence(), 1, ' m/s')}, at z = {valley(runs.finest())[1]:.1f} µm",
               HOLDS if close else f"{QUALITATIVE if limit.value < 2 * paper else NOT}: there is a valley, but not so deep")


def laws(values, speeds=catalogue.SPEEDS):
    """In words how the three laws fit, and the name of the best."""
    found = measures.fits(speeds, values)
    best = min(found, key=lambda name: found[name][2])
    exponent = f" v^{found['power law'][0][1]:.2f}"
    others = ", ".join(f"{name}{exponent if name == 'power law' else ''} +{aic:.0f}" for name, (_, _, aic) in found.items()
                       if name != best)
    if found[best][1] > 0.25 * np.mean(values):
        return f"none of the three (rms {100 * found[best][1] / np.mean(values):.0f}% of the mean at best)", "none"
    return f"{best}{exponent if best == 'power law' else ''} (rms {found[best][1]:.0f} m/s; {others})", best


def speed_laws(runs):
    """Which law of the launch speed describes the extremes: a row for each sign."""
    rows = []
    for word, single, mean, sign in (("largest v_z", "vz_max_m_s", "vz_high_m_s", 1),
                                     ("largest downward speed", "vz_min_m_s", "vz_low_m_s", -1)):
        said, best = [[], []], []
        for time in curves.EXTREME_TIMES:
            scheme = laws([curves.extreme(time, single, sign)(runs.paper(s)) for s in catalogue.SPEEDS])
            ours = laws([curves.converged(runs, s, curves.extreme(time, mean, sign)).value for s in catalogue.SPEEDS])
            for side, (words, _) in zip(said, (scheme, ours)):
                side.append(f"{curves.when(time)}: {words}")
            best.append(ours[1])
        wins = best.count("logarithmic")
        verdict = HOLDS if wins == len(best) else f"{QUALITATIVE}: {wins} of {len(best)} times" if wins else NOT
        rows.append(Row(f"Once the wave has passed, the {word} rises logarithmically with the launch speed",
                        f"the best of three laws through {len(catalogue.SPEEDS)} speeds, {catalogue.SPEEDS[0]} to "
                        f"{catalogue.SPEEDS[-1]} m/s, and how far the AIC of the others is above it", "logarithmic",
                        "; ".join(said[0]), "; ".join(said[1]), verdict))
    return rows


def sizes_of_extremes(runs):
    """Lines of the table of single particles against 12.5 um^3 against nodes."""
    lines = ["| time, ns | of v_z | scheme | single particle | 12.5 µm³ | nodes |", "|---|---|---|---|---|---|"]
    for time in (2, 3, 7.2):
        for word, columns in (("least", ("vz_min_m_s", "vz_low_m_s", "vz_min_grid_m_s")),
                              ("greatest", ("vz_max_m_s", "vz_high_m_s", "vz_max_grid_m_s"))):
            for run in (runs.paper(), *(runs.default(h) for h in runs.mesh_sequence())):
                name = "paper's" if run is runs.paper() else "default"
                numbers = " | ".join(number(run.at(time, c)) for c in columns)
                lines.append(f"| {time:g} | {word} | {name}, {run.config['spacing_um']:g} µm | {numbers} |")
    return lines


def rows(runs):
    return [early_front(runs), extreme(runs, "Waves from the cavity drive material down: -230 m/s at 2 ns", 2, "min", -230),
            extreme(runs, "and -300 m/s at 3 ns", 3, "min", -300), upward(runs), free_surface(runs),
            extreme(runs, "At 7.2 ns v_z peaks at 430 m/s", 7.2, "max", 430),
            extreme(runs, "with a trough of -325 m/s", 7.2, "min", -325), valley_row(runs), *speed_laws(runs)]
