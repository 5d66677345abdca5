"""Claims about pressure, temperature and the bar without a cavity."""

import functools

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import measures
import shapes
from rows import ARTEFACT, HOLDS, NOT, QUALITATIVE, Row, converged, in_full, number, of_default, order, with_bar

SPECIFIC_HEAT = 880  # J/(kg K), of the scene
WALL_LAYER = 2.0     # um above the wall
TOP = 25.0           # um: what is measured around the cavity ends here
POSITIVE = 10.0      # MPa, 1% of the wave's tension: less is ringing


@functools.lru_cache(maxsize=None)
def field(run, time, h=0.5):
    """The grid fields, on a mesh no finer than h."""
    return run.grid(time, max(1, int(round(h / run.config["spacing_um"]))))


def joins(run, time, z_max=30):
    """(from the cavity, past it): the highest pressures, MPa, such that a path of metal with at least so much leads from the
    cavity to the plane between two cavities, and from one such plane to the next, WALL_LAYER to z_max above the wall."""
    grid = field(run, time)
    below = (grid.z <= z_max) & (grid.z >= WALL_LAYER)
    void = grid.cavity(run.config["centre_z_um"])[below]
    p, solid = grid.p[below], grid.solid[below]
    start, goal = np.zeros_like(void), np.zeros_like(void)
    start[:, :, 0] = goal[:, :, -1] = True
    return (measures.joining_level(p, solid, void, goal),
            measures.joining_level(p, solid, start & solid, goal))


def positive(run, time):
    """Volume of metal with P > POSITIVE between WALL_LAYER and TOP, um^3; the highest pressure there, and in the layer at
    the wall, MPa."""
    grid = field(run, time)
    layer = grid.solid & (grid.z < WALL_LAYER)[:, None, None]
    above = grid.solid & ((grid.z >= WALL_LAYER) & (grid.z <= TOP))[:, None, None]
    return float((above & (grid.p > POSITIVE)).sum() * grid.h ** 3), float(grid.p[above].max()), float(grid.p[layer].max())


def isobars_join(runs, time, claim, paper, level):
    """`level`: the weakest tension of the isobars that are said to join, MPa."""
    def words(run):
        return "from the cavity {:.0f} MPa, past it {:.0f} MPa".format(*joins(run, time))

    cavity, past = (converged(runs, lambda run, k=k: joins(run, time)[k]) for k in (0, 1))
    if min(cavity.value, past.value) >= level:
        verdict = HOLDS
    elif past.value >= level:
        verdict = f"{QUALITATIVE}: it runs on past the cavities, which themselves are joined by that of {number(cavity.value)} MPa"
    else:
        verdict = QUALITATIVE + ": they join at another pressure"
    return Row(claim, "highest pressure at which metal of weaker tension makes a path from the cavity to the plane between two "
               f"cavities, and from one such plane to the next ({WALL_LAYER:g} µm < z < 30 µm); isobars of more tension surround "
               "it all", paper, words(runs.paper()),
               f"from the cavity {in_full(cavity, runs.mesh_sequence(), 0, ' MPa')}, past it "
               f"{in_full(past, runs.mesh_sequence(), 0, ' MPa')}",
               verdict)


def no_pressure(runs, time=9):
    def words(run):
        volume, top, wall = positive(run, time)
        return (f"{volume:.0f} µm³ above {POSITIVE:g} MPa, highest {top:.0f} MPa; at the wall {wall:.0f} MPa; "
                f"highest of a particle anywhere {run.at(time, 'p_max_mpa'):.0f} MPa")

    top = converged(runs, lambda run: positive(run, time)[1])
    volume = positive(runs.finest(), time)[0]
    return Row("At 9 ns no pressure is positive", f"nodes {WALL_LAYER:g} to {TOP:g} µm above the wall",
               "none", words(runs.paper()),
               f"highest {in_full(top, runs.mesh_sequence(), 0, ' MPa')}; finest mesh: {words(runs.finest())}",
               HOLDS if top.value - top.bar <= POSITIVE else QUALITATIVE + ": a little is" if volume < 50 else NOT)


def spots(run, time=11, least=20.0):
    """(volume in um^3, height of the middle in um) of the pieces of metal below the cavity's middle with P > 0."""
    grid = field(run, time)
    void = grid.cavity(run.config["centre_z_um"])
    middle = np.average(grid.z[np.nonzero(void)[0]])
    mask = grid.solid & (grid.p > 0) & (grid.z < middle)[:, None, None]
    pieces = measures.components(mask, round(least / grid.h ** 3))
    return [(len(z) * grid.h ** 3, float(grid.z[z].mean())) for z, _, _ in pieces]


def four_spots(runs):
    def free(run):
        return [volume for volume, height in spots(run) if height > WALL_LAYER]

    def words(run):
        at_wall = sum(volume for volume, height in spots(run) if height <= WALL_LAYER)
        return f"{len(free(run))} ({', '.join(f'{v:.0f}' for v in free(run)[:6])} µm³), and {at_wall:.0f} µm³ at the wall"

    counts = [len(free(run)) for run in runs.sides()]
    return Row("At 11 ns there are four spots of positive pressure below the cavity",
               "pieces of at least 20 µm³ with P > 0 lower than the cavity's middle, in one period; those of which the middle is "
               f"within {WALL_LAYER:g} µm of the wall counted apart", "4", words(runs.paper()),
               "; ".join(f"{words(runs.default(h))} on {h:g} µm" for h in runs.mesh_sequence()),
               HOLDS if counts[1] == 4 else ARTEFACT if counts[0] == 4 else NOT)


def isobar_areas(runs, time=11, levels=(0, -50, -100, -150, -200, -250)):
    def areas(run):
        return [shapes.isobar_area(field(run, time), level, 30) for level in levels]

    def words(run):
        return ", ".join(f"{level:g}: {a:.0f}" for level, a in zip(levels, areas(run)))

    at_scheme, largest = (levels[int(np.argmax(areas(run)))] for run in runs.sides())
    ratio = of_default(runs, lambda run: areas(run)[levels.index(-100)] / areas(run)[levels.index(-150)], 2)
    return Row("At 11 ns the isobar of -150 MPa has the largest area", "area in µm² of the isobars, MPa, below 30 µm", "-150 MPa",
               words(runs.paper()), f"{words(runs.finest())}; that of -100 over that of -150 MPa {ratio}",
               HOLDS if largest == -150 else f"{ARTEFACT if at_scheme == -150 else NOT}: that of {largest:g} MPa has")


def particles(run, time=6):
    """Temperature and plastic work over cv of the particles near the cavity."""
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(run.frame("particles", time)))
    reader.Update()
    data = reader.GetOutput()
    points = 1e6 * vtk_to_numpy(data.GetPoints().GetData())
    near = (np.hypot(points[:, 0], points[:, 1]) < 15) & (points[:, 2] < 30)
    temperature, work = (vtk_to_numpy(data.GetPointData().GetArray(name))[near] for name in ("temperature", "plastic_work"))
    return temperature.astype(float), work.astype(float) / SPECIFIC_HEAT


def hot_spots(runs):
    def numbers(run):
        t, heat = particles(run)
        hot = t >= np.quantile(t, 0.99)
        return np.corrcoef(t, heat)[0, 1], np.mean(heat[hot] >= np.quantile(heat, 0.99)), np.mean(t[hot] - 300), np.mean(heat[hot])

    def words(run):
        r, shared, rise, heat = numbers(run)
        return (f"correlation {r:.3f}; {100 * shared:.0f}% of the hottest 1% are among the 1% with most plastic work; they are "
                f"{rise:.1f} K above the start, plastic work alone gives {heat:.1f} K")

    ours = runs.default(runs.set.trend[-1])
    found = numbers(ours)
    return Row("Local temperatures and hot spots are determined by the plastic work",
               "particles at 6 ns within 15 µm of the axis, below 30 µm: temperature against plastic work over the specific heat; "
               "the rest is the cooling of the stretched metal", "", words(runs.paper()),
               f"{words(ours)} (on {ours.config['spacing_um']:g} µm)", HOLDS if found[0] > 0.9 and found[1] > 0.8 else QUALITATIVE)


def bar(runs, times=(3, 7, 9)):
    def unevenness(run):
        worst = 0
        for time in times:
            grid = run.grid(time)
            full = (grid.fraction > 0.5).all(axis=(1, 2))
            v = grid.vz[full].astype(float)
            worst = max(worst, float((v.max(axis=(1, 2)) - v.min(axis=(1, 2))).max()))
        return worst

    sides = [unevenness(runs[f"{name}_bar"]) for name in ("paper", "default")]
    return Row("Without a cavity the motion is one-dimensional", "greatest difference of v_z within a plane of nodes, at "
               f"{', '.join(map(str, times))} ns (fields are stored in single precision)", "", f"{sides[0]:.2g} m/s",
               f"{sides[1]:.2g} m/s", HOLDS if max(sides) < 0.01 else NOT)


def weak_tension(runs, times=(3, 7.2, 11)):
    """The abstract's second cavity effect."""
    def words(run):
        return "; ".join("{:g} ns: {:.0f} µm³, highest {:.0f} MPa, at the wall {:.0f} MPa".format(t, *positive(run, t))
                         for t in times)

    tops = [converged(runs, lambda run, t=t: positive(run, t)[1]) for t in times]
    shown = [f" ({order(top)})" if order(top) else "" for top in tops]
    said = ", ".join(f"{with_bar(top)} MPa at {t:g} ns{by}" for t, top, by in zip(times, tops, shown))
    return Row("Around the cavity tension is weaker, and pressure even positive in places",
               f"metal with P > {POSITIVE:g} MPa (less is ringing), {WALL_LAYER:g} to {TOP:g} µm above the wall", "",
               words(runs.paper()),
               f"highest {said}; finest mesh: {words(runs.finest())}",
               HOLDS if any(top.value - top.bar > POSITIVE for top in tops) else QUALITATIVE + ": weaker, nowhere positive")


def rows(runs):
    return [weak_tension(runs),
            isobars_join(runs, 9, "At 9 ns the isobars of -300 to -550 MPa join neighbouring cavities", "-300 to -550 MPa",
                         -300),
            no_pressure(runs), four_spots(runs),
            isobars_join(runs, 11, "At 11 ns the isobar of -100 MPa joins neighbouring cavities", "-100 MPa",
                         -100),
            isobar_areas(runs), hot_spots(runs), bar(runs)]
