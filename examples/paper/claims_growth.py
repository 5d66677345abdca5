"""Claims about the cavity's growth and shape."""

import functools

import numpy as np

import catalogue
import curves
import measures
import shapes
from rows import (ARTEFACT, HOLDS, NOT, QUALITATIVE, Row, converged, in_full, number, of_default, order, percent, spread,
                  with_bar)

VOLUME, WIDTH, HEIGHT = "cavity_volume_um3", "cavity_width_um", "cavity_height_um"


def stages(run, count=5):
    """Ends (ns), slopes and rms of the best `count` straight pieces of the volume; rms of 1 to 7 pieces."""
    t, v = run.history["time_ns"], run.history[VOLUME]
    good = np.isfinite(v) & (t <= 12 + 1e-6)
    t, v = t[good], v[good]
    starts, slopes, _ = measures.segments(t, v, count)
    return [t[s] for s in starts[1:]], slopes, [measures.segments(t, v, k)[2] for k in range(1, 8)]


def five_stages(runs):
    said = []
    for run in runs.sides():
        ends, slopes, _ = stages(run)
        said.append("bounds " + ", ".join(f"{e:.1f}" for e in ends) + " ns; rates " + ", ".join(f"{s:.0f}" for s in slopes) +
                    " µm³/ns")
    rms = [stages(run)[2] for run in runs.sides()]
    gain = [a / b for a, b in zip(rms[1], rms[1][1:])]
    distinct = int(np.argmax(gain)) + 2
    fit = "rms of 1 to 7 pieces: " + ", ".join(f"{r:.1f}" for r in rms[1]) + " µm³"
    return Row("The cavity grows in stages (five)",
               "best division of V(t) to 12 ns into five straight pieces; whether five is a special number shows in how much "
               "each further piece improves the fit", "five stages", said[0], f"{said[1]}; {fit}",
               HOLDS if distinct == 5 else
               f"{QUALITATIVE}: the rate changes as said, but five is no special number (the fit gains most from piece number {distinct})")


def linearity(run, column, stage=curves.LINEAR_STAGE):
    """1 - R^2 of a straight line over the linear stage."""
    t, y = run.history["time_ns"], run.history[column]
    use = (t >= stage[0] - 1e-6) & (t <= stage[1] + 1e-6)
    return 1 - float(np.corrcoef(t[use], y[use])[0, 1] ** 2)


def linear_stage(runs):
    def words(run):
        parts = []
        for column, name in ((VOLUME, "volume"), (WIDTH, "width"), (HEIGHT, "height")):
            early, late = (curves.growth_rate(run, column, s) for s in ((3, 4), (6, 7)))
            parts.append(f"{name}: R² = {1 - linearity(run, column):.4f}, rate from {early:.3g} to {late:.3g}")
        return "; ".join(parts)

    change = [curves.growth_rate(runs.finest(), VOLUME, s) for s in ((3, 4), (6, 7))]
    steady = abs(change[1] / change[0] - 1)
    return Row("After a slow start, volume and extents grow linearly until the wave reaches the free surface",
               f"straight line from {curves.LINEAR_STAGE[0]:g} to {curves.LINEAR_STAGE[1]:g} ns; slopes (µm³/ns, µm/ns) over 3 to "
               "4 and 6 to 7 ns", "linear", words(runs.paper()), words(runs.finest()),
               HOLDS if steady < 0.1 else f"{QUALITATIVE}: the volume's rate changes by {100 * steady:.0f}%")


def overtakes(run):
    """When the width's rate is above the height's for good (to 7 ns), and when width is above height for good, ns."""
    t, w, h = (run.history[c] for c in ("time_ns", WIDTH, HEIGHT))
    window = 10  # samples: 1 ns
    times = t[window // 2:len(t) - window // 2]
    rate = (w - h)[window:] - (w - h)[:-window]
    slow = times[(rate <= 0) & (times <= 7)]
    narrow = t[(w <= h) & (t <= 7)]
    return (float(slow[-1]) if slow.size else 0.0), (float(narrow[-1]) if narrow.size else 0.0)


def horizontal(runs):
    def rates(run):
        return [curves.growth_rate(run, c) for c in (WIDTH, HEIGHT)]

    def words(run):
        faster, wider = overtakes(run)
        w, h = rates(run)
        return f"{w:.2f} against {h:.2f} µm/ns; faster from {faster:.1f} ns on, wider than high from {wider:.1f} ns on"

    ratio = converged(runs, lambda run: rates(run)[0] / rates(run)[1])
    return Row("Across the launch it grows faster than along it",
               "slopes of width and height from 3 to 7 ns; from when on, to 7 ns (rates over 1 ns)", "faster", words(runs.paper()),
               f"{words(runs.finest())}; ratio {in_full(ratio, runs.mesh_sequence(), 2)}",
               HOLDS if ratio.value - ratio.bar > 1 else NOT)


def largest_rate(run, window=20):
    """The largest rise of the volume over 2 ns (samples of 0.1 ns) until 12 ns, um^3/ns."""
    use = run.history["time_ns"] <= 12 + 1e-6
    t, v = run.history["time_ns"][use], run.history[VOLUME][use]
    return float(np.nanmax((v[window:] - v[:-window]) / (t[window:] - t[:-window])))


def rate_law(runs):
    speeds = catalogue.SPEEDS

    def words(values):
        found = measures.fits(speeds, values)
        line, power = found["linear"], found["power law"]
        text = (f"{line[0][1]:.2f} v {line[0][0]:+.0f} µm³/ns, R² = {1 - (line[1] / np.std(values)) ** 2:.3f}; power law "
                f"v^{power[0][1]:.2f}, of which the AIC differs by {power[2] - line[2]:+.0f}")
        return text, line[1] / np.mean(values), 1 - (line[1] / np.std(values)) ** 2, power[0][1]

    scheme = [words([rate(runs.paper(s)) for s in speeds])[0] for rate in (curves.growth_rate, largest_rate)]
    ours = [words([curves.converged(runs, s, rate).value for s in speeds]) for rate in (curves.growth_rate, largest_rate)]
    _, off, r2, exponent = ours[0]
    return Row("The growth rate of the volume is linear in the launch speed",
               f"slope of V from 3 to 7 ns, and largest rise over 2 ns, at {len(speeds)} speeds, {speeds[0]} to {speeds[-1]} m/s; "
               "straight line against power law (the lower AIC is the better law)", "linear", f"{scheme[0]}; largest: {scheme[1]}",
               f"{ours[0][0]}; largest: {ours[1][0]}",
               HOLDS if off < 0.03 else f"{QUALITATIVE}: nearly, but faster than linear (v^{exponent:.2f})" if r2 > 0.95 else NOT)


@functools.lru_cache(maxsize=None)
def surface(run, time):
    return shapes.Surface(run.grid(time), run.config["centre_z_um"])


def flatness(run, time, upper=False):
    return surface(run, time).flatness(upper)


def flat_face(runs):
    def words(slow, fast):
        faces = [f"{name} {flatness(slow, 0, up):.2f}, {flatness(slow, 7.2, up):.2f}, {flatness(slow, 12, up):.2f}"
                 for name, up in (("lower", False), ("upper", True))]
        return f"100 m/s: {'; '.join(faces)}. 1000 m/s: lower {flatness(fast, 7.2):.2f}, {flatness(fast, 12):.2f} (7.2, 12 ns)"

    slow, upper = (converged(runs, lambda run, up=up: flatness(run, 12, up)) for up in (False, True))
    quick = converged(runs, lambda run: flatness(run, 7.2), 1000)
    flat, flatter = abs(slow.value) < 0.35, slow.value + slow.bar < upper.value
    verdict = (HOLDS if flat and flatter else f"{HOLDS} at 1000 m/s, where it meets the wall; at 100 m/s it is flatter than the upper one"
               if abs(quick.value) < 0.35 and flatter else QUALITATIVE + ": flatter than the upper one" if flatter else NOT)
    return Row("The lower face of the cavity becomes flat",
               "flatness number: sagitta of the face out to 0.65 of the half width, over a sphere's (1 round, 0 flat, negative: "
               "bulging inwards), at 0, 7.2, 12 ns", "flat", words(runs.paper(), runs.paper(1000)),
               f"{words(runs.finest(), runs.finest(1000))}. Lower at 100 m/s, 12 ns "
               f"{in_full(slow, runs.mesh_sequence(), 2)}; at 1000 m/s, 7.2 ns {in_full(quick, runs.mesh_sequence(1000), 2)}",
               verdict)


def roughness(run, time=12):
    return 100 * surface(run, time).roughness()


def irregular(runs):
    meshes = runs.mesh_sequence()
    limit = converged(runs, roughness)
    jitter, around = spread(runs, roughness)
    jitter_ours, around_ours = spread(runs, roughness, "default")
    other = runs["paper_other_mesh"]
    scheme = (f"{roughness(runs.paper()):.2f}% ({roughness(runs.paper(), 0):.2f}% at the start) with whole particles, "
              f"{roughness(runs['paper_fraction']):.2f}% with particles cut at the surface, {jitter:.2f} ± {around:.2f}% on "
              f"jittered lattices, {roughness(other):.2f}% on {other.config['spacing_um']:g} µm; at 1000 m/s "
              f"{roughness(runs.paper(1000)):.2f}%")
    default = (f"{in_full(limit, meshes, 2, '%')}; {roughness(runs.finest(), 0):.2f}% at the start on {meshes[-1]:g} µm; on "
               f"{meshes[0]:g} µm {roughness(runs['default_lattice']):.2f}% with whole particles, {jitter_ours:.2f} ± "
               f"{around_ours:.2f}% jittered; at 1000 m/s {of_default(runs, roughness, 2, 1000, '%')}")
    return Row("The deformed cavity is irregular, because of an instability of Richtmyer and Meshkov's kind",
               "roughness at 12 ns: rms of the surface's radius beyond spherical harmonics of degree 6, over its mean; an "
               "instability of the metal would persist on finer meshes, and care little for the way of filling", "irregular",
               scheme, default, HOLDS if limit.value > 0.7 * roughness(runs.paper()) else
               f"{ARTEFACT} at 100 m/s: the finer the mesh, the smoother the surface (at 1000 m/s the edge at the wall counts)"
               if limit.values[-1] < limit.values[0] else NOT)


def conduction(runs):
    def words(with_heat, without, end=12):
        parts = [(name, with_heat.at(end, c) / without.at(end, c) - 1) for c, name in
                 ((VOLUME, "volume"), ("vz_high_m_s", "v_z high"), ("vz_low_m_s", "v_z low"))]
        rise = [run.at(end, "t_max_k") for run in (with_heat, without)]
        changes = ", ".join(f"{name} {percent(x, 2)}" for name, x in parts)
        return f"{changes}; hottest particle {rise[0]:.1f} K instead of {rise[1]:.1f} K"

    ours, without = runs["choice_conducting_v100"], runs["choice_default_v100"]
    change = abs(ours.at(12, VOLUME) / without.at(12, VOLUME) - 1)
    cooled = 1 - (ours.at(12, "t_max_k") - 300) / (without.at(12, "t_max_k") - 300)
    return Row("Heat conduction is much slower than the motion", "237 W/(m K) against none, at 12 ns", "negligible",
               words(runs["paper_conduction"], runs.paper()), f"{words(ours, without)} (on {ours.config['spacing_um']:g} µm)",
               (HOLDS if change < 0.002 else NOT) +
               f": as to the motion; the hottest particle loses {100 * cooled:.0f}% of its rise")


def volumes(runs):
    """The cavity's volume at three times: no claim of the paper, but what the others rest on."""
    lines = ["| launch, m/s | time, ns | paper's scheme | default scheme by mesh | converged | order |", "|---|---|---|---|---|---|"]
    for speed in curves.SHOWN:
        for time in (3, 7.2, 12):
            def volume(run, t=time):
                return run.at(t, VOLUME)
            limit = converged(runs, volume, speed)
            by_mesh = ", ".join(f"{number(v)} ({h:g} µm)" for h, v in zip(runs.mesh_sequence(speed), limit.values))
            lines.append(f"| {speed} | {time:g} | {number(runs.paper(speed).at(time, VOLUME))} | {by_mesh} | {with_bar(limit)} | "
                         f"{order(limit).replace('no order', 'none').removeprefix('order ')} |")
    return lines


def rows(runs):
    return [five_stages(runs), linear_stage(runs), horizontal(runs), rate_law(runs), flat_face(runs), irregular(runs),
            conduction(runs)]
