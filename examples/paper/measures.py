"""Reads runs of the cavity and measures them. Units: um, ns, m/s, MPa, K."""

import functools
import heapq
import json
import pathlib
import sys
import typing

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cavity"))
import plot_frames  # noqa: E402  (reads .vti and .pvd with VTK)
from vtk.util.numpy_support import vtk_to_numpy  # noqa: E402


class Missing(Exception):
    """A run or a frame that is needed is not there; one sentence."""


def table(path):
    """Column name -> array."""
    if not path.exists():
        raise Missing(f"{path.parent.name} has no {path.name}; run reproduce_paper.sh without --figures-only first")
    rows = np.genfromtxt(path, delimiter=",", names=True)
    return {name: np.atleast_1d(rows[name]) for name in rows.dtype.names}


class Run:
    """A run's folder."""

    def __init__(self, folder):
        self.folder, self.name = pathlib.Path(folder), pathlib.Path(folder).name
        if not (self.folder / "summary.json").exists():
            raise Missing(f"the run {self.name} is not there; run reproduce_paper.sh without --figures-only first")
        self.summary = json.loads((self.folder / "summary.json").read_text())
        self.config = self.summary["configuration"]

    @functools.cached_property
    def history(self):
        return table(self.folder / "history.csv")

    @functools.cached_property
    def axis(self):
        return table(self.folder / "axis.csv")

    def at(self, time, column):
        """A column of the history at a time; nan if the run did not come so far."""
        t = self.history["time_ns"]
        if time > t[-1] + 1e-6:
            return np.nan
        return float(np.interp(time, t, self.history[column]))

    def profile(self, time, column):
        """z and a column of axis.csv at the frame nearest to a time."""
        t = self.axis["time_ns"]
        rows = np.abs(t - t[np.argmin(np.abs(t - time))]) < 1e-6
        return self.axis["z_um"][rows], self.axis[column][rows]

    def frame(self, kind, time):
        folder = self.folder / "frames"
        listed = plot_frames.ElementTree.parse(folder / f"{kind}.pvd").getroot() if (folder / f"{kind}.pvd").exists() else ()
        for entry in (listed.iter("DataSet") if len(listed) else ()):
            if abs(1e9 * float(entry.get("timestep")) - time) < 1e-3:
                return folder / entry.get("file")
        raise Missing(f"the run {self.name} has no {kind} frame at {time:g} ns")

    def grid(self, time, stride=1):
        return Grid(plot_frames.read(self.frame("grid", time)), stride)


class Grid:
    """Fields on the nodes of the whole body, arrays [z, y, x]; every stride-th node is taken."""

    NAMES = {"fraction": ("volume_fraction", 1), "rho": ("density", 1), "p": ("pressure", 1e-6), "t": ("temperature", 1)}

    def __init__(self, image, stride):
        nx, ny, nz = image.GetDimensions()
        spacing, bounds = image.GetSpacing(), image.GetBounds()
        self.h = 1e6 * spacing[0] * stride
        self.x, self.y, self.z = (1e6 * (bounds[2 * a] + spacing[a] * np.arange(n))[::stride]
                                  for a, n in enumerate((nx, ny, nz)))
        data = image.GetPointData()
        for name, (array, scale) in self.NAMES.items():
            values = vtk_to_numpy(data.GetArray(array)).reshape(nz, ny, nx)[::stride, ::stride, ::stride]
            setattr(self, name, (scale * values).astype(np.float32))
        velocity = vtk_to_numpy(data.GetArray("velocity")).reshape(nz, ny, nx, 3)[::stride, ::stride, ::stride]
        self.vx, self.vy, self.vz = (velocity[..., a].copy() for a in range(3))
        if abs(self.x[0]) < 1e-6:
            self.mirror()

    def mirror(self):
        """Completes a quarter by its images about x = 0 and y = 0."""
        for axis, place, odd in ((2, "x", "vx"), (1, "y", "vy")):
            for name in ("fraction", "rho", "p", "t", "vx", "vy", "vz"):
                values = getattr(self, name)
                image = np.flip(values, axis).take(range(values.shape[axis] - 1), axis)
                setattr(self, name, np.concatenate([-image if name == odd else image, values], axis))
            half = getattr(self, place)
            setattr(self, place, np.concatenate([-half[:0:-1], half]))

    @property
    def solid(self):
        return self.fraction >= 0.5

    def cavity(self, centre_z):
        """Mask of the void that holds the point nearest to (0, 0, centre) of those that are void."""
        void = np.argwhere(~self.solid)
        offset = np.stack([self.z[void[:, 0]] - centre_z, self.y[void[:, 1]], self.x[void[:, 2]]])
        return flood(~self.solid, tuple(void[np.argmin((offset ** 2).sum(axis=0))]))

    def rectangle(self, array):
        """The cut x = 0, [z, y]."""
        return array[:, :, int(np.argmin(np.abs(self.x)))]


class Flood:
    """Pieces of a mask [z, y, x], joined through the six neighbours of a node."""

    def __init__(self, mask):
        padded = np.pad(mask, 1)
        self.shape, self.left = padded.shape, padded.ravel()
        _, ny, nx = self.shape
        self.steps = np.array([-1, 1, -nx, nx, -nx * ny, nx * ny])

    def piece(self, node):
        """Takes out the piece that holds a node (a flat number in the padded mask); returns its nodes."""
        front = np.array([node])[self.left[[node]]]
        self.left[front] = False
        found = [front]
        while front.size:
            near = np.unique(front[:, None] + self.steps)
            front = near[self.left[near]]
            self.left[front] = False
            found.append(front)
        return np.concatenate(found)


def flood(mask, seed):
    """The nodes of a mask that are joined to a node through their six neighbours, as a mask."""
    pieces = Flood(mask)
    grown = np.zeros(pieces.left.size, bool)
    grown[pieces.piece(np.ravel_multi_index(np.add(seed, 1), pieces.shape))] = True
    return grown.reshape(pieces.shape)[1:-1, 1:-1, 1:-1]


def components(mask, least):
    """Indices (z, y, x) of the nodes of the pieces of a mask that have at least so many, the largest piece first."""
    pieces = Flood(mask)
    found = [pieces.piece(node) for node in np.flatnonzero(pieces.left) if pieces.left[node]]
    found = sorted((nodes for nodes in found if len(nodes) >= least), key=len, reverse=True)
    return [np.subtract(np.unravel_index(nodes, pieces.shape), 1) for nodes in found]


def joining_level(values, inside, seeds, goal):
    """The highest level such that a path of inside nodes with values >= level leads from the seeds to the goal."""
    flat, inside, goal = values.ravel().tolist(), inside.ravel(), goal.ravel()
    nz, ny, nx = values.shape
    done = np.zeros(values.size, bool)
    heap = [(-np.inf, int(i)) for i in np.flatnonzero(seeds.ravel())]
    heapq.heapify(heap)
    while heap:
        negative, node = heapq.heappop(heap)
        if done[node]:
            continue
        done[node] = True
        if goal[node]:
            return -negative
        x, y, z = node % nx, node // nx % ny, node // (nx * ny)
        for at, size, step in ((x, nx, 1), (y, ny, nx), (z, nz, nx * ny)):
            for other in ((node - step,) if at == size - 1 else (node + step,) if at == 0 else (node - step, node + step)):
                if inside[other] and not done[other]:
                    heapq.heappush(heap, (max(negative, -flat[other]), other))
    return -np.inf


class Limit(typing.NamedTuple):
    """What values on ever finer meshes go to: with its error bar, and the order that three meshes show (nan: none)."""
    value: float
    bar: float
    order: float
    values: tuple  # by mesh


def converge(meshes, values):
    """The limit of values on meshes from coarse to fine.

    Three meshes: if the changes show an order between 0.5 and 3, Richardson's value with that order (at most 2 is used),
    and the whole correction as the bar. Else the finest value, and as the bar the last change, but no less than what
    order 2 would have made of the change before; where the changes keep their sign and fall more slowly than order 0.5,
    or grow, all that order 0.5 would still add. Two meshes: the value of order 2, and the distance to that of order 1 as
    the bar. One mesh: no bar.
    """
    pairs = [(h, v) for h, v in zip(meshes, values) if np.isfinite(v)]
    if len(pairs) < 2:
        return Limit(pairs[0][1] if pairs else np.nan, np.nan, np.nan, tuple(values))
    (h2, f2), (h3, f3) = pairs[-2:]
    ratio, last = h2 / h3, f3 - f2
    if len(pairs) == 2:
        second = last / (ratio ** 2 - 1)
        return Limit(f3 + second, abs(last / (ratio - 1) - second), np.nan, tuple(values))
    before = f2 - pairs[-3][1]
    order = float(np.log(before / last) / np.log(ratio)) if last != 0 and before / last > 1 else np.nan
    if 0.5 <= order <= 3:
        correction = last / (ratio ** min(order, 2) - 1)
        return Limit(f3 + correction, abs(correction), order, tuple(values))
    slow = before * last > 0 and not order > 3
    bar = abs(last) / (ratio ** 0.5 - 1) if slow else max(abs(last), abs(before) / ratio ** 2)
    return Limit(f3, bar, order, tuple(values))


def fits(speeds, values):
    """Least squares of values against speeds: name -> (parameters, rms, difference of AIC to the best)."""
    v, y = np.asarray(speeds, float), np.asarray(values, float)

    def linear(column):
        a = np.stack([np.ones_like(v), column], axis=1)
        solution = np.linalg.lstsq(a, y, rcond=None)[0]
        return solution, float(((a @ solution - y) ** 2).sum())

    def power(exponent):
        column = v ** exponent
        factor = (column * y).sum() / (column ** 2).sum()
        return factor, float(((factor * column - y) ** 2).sum())

    exponents = np.linspace(0.01, 3, 3000)
    best = exponents[np.argmin([power(b)[1] for b in exponents])]
    found = {"linear": linear(v), "logarithmic": linear(np.log(v)), "power law": ((power(best)[0], best), power(best)[1])}
    least = min(squares for _, squares in found.values())
    return {name: (parameters, np.sqrt(squares / len(y)), len(y) * np.log(squares / least))
            for name, (parameters, squares) in found.items()}


def evaluate(name, parameters, v):
    a, b = parameters
    return a * v ** b if name == "power law" else a + b * (np.log(v) if name == "logarithmic" else v)


def segments(t, y, count, least=6):
    """The best fit of `count` straight pieces (dynamic programming): (first indices, slopes, rms)."""
    n = len(t)
    sums = [np.concatenate([[0], np.cumsum(q)]) for q in (np.ones(n), t, y, t * t, t * y, y * y)]

    def piece(i, j):  # samples i ... j - 1: (squares, slope)
        m, st, sy, stt, sty, syy = (s[j] - s[i] for s in sums)
        slope = (sty - st * sy / m) / (stt - st * st / m)
        return max(syy - sy * sy / m - slope * (sty - st * sy / m), 0.0), slope

    best = np.full((count + 1, n + 1), np.inf)
    origin = np.zeros((count + 1, n + 1), int)
    best[0, 0] = 0
    for k in range(1, count + 1):
        for j in range(k * least, n + 1):
            costs = [best[k - 1, i] + piece(i, j)[0] for i in range((k - 1) * least, j - least + 1)]
            i = int(np.argmin(costs))
            best[k, j], origin[k, j] = costs[i], i + (k - 1) * least
    starts, j = [], n
    for k in range(count, 0, -1):
        starts.insert(0, origin[k, j])
        j = origin[k, j]
    slopes = [piece(i, j)[1] for i, j in zip(starts, [*starts[1:], n])]
    return starts, slopes, float(np.sqrt(best[count, n] / n))
