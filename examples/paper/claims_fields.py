"""Claims about pressure, temperature and the bar without a cavity."""

import functools

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import measures
import shapes
from rows import ARTEFACT, HOLDS, NOT, QUALITATIVE, Row, converged, number, of_default, with_bar

SPECIFIC_HEAT = 880  # J/(kg K), of the scene


@functools.lru_cache(maxsize=None)
def field(run, time, h=0.5):
    """The grid fields, on a mesh no finer than h."""
    return run.grid(time, max(1, int(round(h / run.config["spacing_um"]))))


def joins(run, time, z_max=30):
    """The pressure of the isobar at which the weak tension around the cavity joins that of its neighbours, MPa: the highest
    p such that a path of metal with at least p leads from the cavity to the plane between two cavities."""
    grid = field(run, time)
    below = grid.z <= z_max
    void = grid.cavity(run.config["centre_z_um"])[below]
    goal = np.zeros_like(void)
    goal[:, :, -1] = True
    return measures.joining_level(grid.p[below], grid.solid[below], void, goal)


def positive(run, time):
    """Volume of metal under pressure, within 15 um of the axis and the lowest 35 um, um^3, and the highest pressure there."""
    grid = field(run, time)
    near = grid.solid & (grid.z < 35)[:, None, None] & (np.hypot(grid.x[None, :], grid.y[:, None]) < 15)[None]
    return float((near & (grid.p > 0)).sum() * grid.h ** 3), float(grid.p[near].max())


def isobars_join(runs, time, paper, reached):
    def words(run):
        return f"{joins(run, time):.0f} MPa"

    level, bar, _ = converged(runs, lambda run: joins(run, time))
    return Row(f"At {time:g} ns isobars join neighbouring cavities",
               "highest pressure at which the region of weaker tension around the cavity reaches the plane between two cavities "
               "(z < 30 µm)", paper, words(runs.paper()), of_default(runs, lambda run: joins(run, time)) + " MPa",
               HOLDS if reached[0] <= level <= reached[1] else QUALITATIVE + ": at another pressure")


def no_pressure(runs, time=9):
    def words(run):
        volume, top = positive(run, time)
        return f"{volume:.0f} µm³ above zero, highest {top:.0f} MPa; highest of a particle anywhere {run.at(time, 'p_max_mpa'):.0f} MPa"

    top, bar, _ = converged(runs, lambda run: positive(run, time)[1])
    return Row("At 9 ns no pressure is positive", "nodes within 15 µm of the axis, below 35 µm", "none", words(runs.paper()),
               f"highest {with_bar(top, bar)} MPa; finest mesh: {words(runs.finest())}",
               HOLDS if top - bar <= 0 else QUALITATIVE + ": a little is" if positive(runs.finest(), time)[0] < 20 else NOT)


def spots(run, time=11, least=1.0):
    """Volumes (um^3) of the pieces of metal under the cavity's centre with P > 0."""
    grid = field(run, time)
    void = grid.cavity(run.config["centre_z_um"])
    middle = np.average(grid.z[np.nonzero(void)[0]])
    mask = grid.solid & (grid.p > 0) & (grid.z < middle)[:, None, None]
    return [n * grid.h ** 3 for n in measures.components(mask, max(1, round(least / grid.h ** 3)))]


def four_spots(runs):
    def words(run):
        found = spots(run)
        return f"{len(found)} ({', '.join(f'{v:.0f}' for v in found[:6])} µm³)" if found else "none"

    finest = len(spots(runs.finest()))
    scheme = len(spots(runs.paper()))
    return Row("At 11 ns there are four spots of positive pressure under the cavity",
               "pieces of at least 1 µm³ with P > 0 below the cavity's middle", "4", words(runs.paper()),
               "; ".join(f"{words(runs.default(h))} on {h:g} µm" for h in runs.set.fields),
               HOLDS if finest == 4 else f"{ARTEFACT}" if scheme == 4 else NOT)


def isobar_areas(runs, time=11, levels=(0, -50, -100, -150, -200, -250)):
    def areas(run):
        return [shapes.isobar_area(field(run, time), level, 30) for level in levels]

    def words(run):
        return ", ".join(f"{level:g}: {a:.0f}" for level, a in zip(levels, areas(run)))

    largest = levels[int(np.argmax(areas(runs.finest())))]
    return Row("At 11 ns the isobar of -150 MPa has the largest area", "area in µm² of the isobars, MPa, below 30 µm", "-150 MPa",
               words(runs.paper()), words(runs.finest()), HOLDS if largest == -150 else f"{NOT}: that of {largest:g} MPa")


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
               f"{', '.join(map(str, times))} ns (fields are stored in single precision)", "", f"{sides[0]:.1e} m/s",
               f"{sides[1]:.1e} m/s", HOLDS if max(sides) < 0.01 else NOT)


def weak_tension(runs):
    """The abstract's second cavity effect."""
    def words(run):
        return "; ".join(f"{t:g} ns: {number(positive(run, t)[0])} µm³, highest {number(positive(run, t)[1])} MPa" for t in (3, 7.2, 11))

    tops = [converged(runs, lambda run, t=t: positive(run, t)[1])[:2] for t in (3, 7.2, 11)]
    said = ", ".join(f"{with_bar(*top)} MPa at {t:g} ns" for t, top in zip((3, 7.2, 11), tops))
    return Row("Around the cavity tension is weaker, and pressure even positive in places",
               "metal with P > 0 within 15 µm of the axis, below 35 µm", "", words(runs.paper()),
               f"highest {said}; finest mesh: {words(runs.finest())}",
               HOLDS if any(value - bar > 0 for value, bar in tops) else QUALITATIVE + ": weaker, nowhere positive")


def rows(runs):
    return [weak_tension(runs), isobars_join(runs, 9, "-300 to -550 MPa", (-550, -300)), no_pressure(runs), four_spots(runs),
            isobars_join(runs, 11, "-100 MPa", (-125, -75)), isobar_areas(runs), hot_spots(runs), bar(runs)]
