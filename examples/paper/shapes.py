"""Measures of the cavity's surface and of isosurfaces, from a Grid. Lengths in um."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk


def image_of(grid, **fields):
    """A vtkImageData with these arrays [z, y, x] on the grid's nodes, in um."""
    image = vtk.vtkImageData()
    image.SetDimensions(len(grid.x), len(grid.y), len(grid.z))
    image.SetOrigin(grid.x[0], grid.y[0], grid.z[0])
    image.SetSpacing(grid.h, grid.h, grid.h)
    for name, values in fields.items():
        array = numpy_to_vtk(np.ascontiguousarray(values, np.float32).ravel(), deep=1)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    return image


def isosurface(image, name, level):
    """A vtkPolyData: the surface name = level, with the other arrays on it."""
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    contour.SetValue(0, level)
    contour.InterpolateAttributesOn()
    contour.Update()
    return contour.GetOutput()


def kept(surface, name, level):
    """The part of a surface where an array on it is at least `level`."""
    if surface.GetNumberOfPoints() == 0:
        return surface
    surface.GetPointData().SetActiveScalars(name)
    clip = vtk.vtkClipPolyData()
    clip.SetInputData(surface)
    clip.SetValue(level)
    clip.Update()
    return clip.GetOutput()


def area(surface):
    if surface.GetNumberOfCells() == 0:
        return 0.0
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(surface)
    mass = vtk.vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    mass.Update()
    return mass.GetSurfaceArea()


def carried_into_void(values, solid, layers=3):
    """A field carried a few nodes into the void, so that surfaces end at the metal's boundary and not before it."""
    values, known = np.where(solid, values, 0).astype(np.float32), solid.copy()
    for _ in range(layers):
        total, count = np.zeros_like(values), np.zeros_like(values)
        for axis in range(3):
            for step in (-1, 1):
                moved_values, moved_known = np.roll(values * known, step, axis), np.roll(known, step, axis)
                edge = [slice(None)] * 3
                edge[axis] = 0 if step == 1 else -1
                moved_known[tuple(edge)] = False
                total += np.where(moved_known, moved_values, 0)
                count += moved_known
        fresh = ~known & (count > 0)
        values[fresh] = total[fresh] / count[fresh]
        known |= fresh
    return values


def isobar_area(grid, level, z_max):
    """Area of the surface p = level in the metal below z_max."""
    below = grid.z <= z_max
    cut = type("Part", (), {"x": grid.x, "y": grid.y, "z": grid.z[below], "h": grid.h})
    image = image_of(cut, p=carried_into_void(grid.p, grid.solid)[below], fraction=grid.fraction[below])
    return area(kept(isosurface(image, "p", level), "fraction", 0.5))


def interpolate(grid, values, points):
    """Trilinear, of an array [z, y, x] at points [..., (x, y, z)]."""
    result, index, part = 0.0, [], []
    for a, places in ((2, grid.z), (1, grid.y), (0, grid.x)):
        u = np.clip((points[..., a] - places[0]) / grid.h, 0, len(places) - 1.000001)
        index.append(u.astype(int))
        part.append(u - u.astype(int))
    for corner in range(8):
        bits = [corner >> k & 1 for k in range(3)]
        weight = np.prod([f if b else 1 - f for f, b in zip(part, bits)], axis=0)
        result = result + weight * values[tuple(i + b for i, b in zip(index, bits))]
    return result


class Surface:
    """The cavity's surface by rays from the void's centre: radius r in directions [polar angle, azimuth]."""

    def __init__(self, grid, centre_z, reach=19.0):
        void = grid.cavity(centre_z)
        z, y, x = (np.average(places[nodes]) for places, nodes in zip((grid.z, grid.y, grid.x), np.nonzero(void)))
        self.centre = np.array([x, y, z])
        polar = (np.arange(60) + 0.5) * np.pi / 60
        azimuth = (np.arange(120) + 0.5) * 2 * np.pi / 120
        self.polar, self.azimuth = np.meshgrid(polar, azimuth, indexing="ij")
        self.direction = np.stack([np.sin(self.polar) * np.cos(self.azimuth), np.sin(self.polar) * np.sin(self.azimuth),
                                   np.cos(self.polar)], axis=-1)
        along = np.arange(0, reach, grid.h / 4)
        self.r = np.full(self.polar.shape, np.nan)
        before = None
        for a in along:
            now = interpolate(grid, grid.fraction, self.centre + a * self.direction)
            if before is not None:
                hit = np.isnan(self.r) & (now >= 0.5)
                self.r[hit] = (a - grid.h / 4 * (now - 0.5) / np.maximum(now - before, 1e-9))[hit]
            before = now

    @property
    def points(self):
        return self.centre + self.r[..., None] * self.direction

    def roughness(self, degree=6):
        """Root mean square of r's rest after spherical harmonics up to `degree`, over its mean."""
        good = np.isfinite(self.r)
        n, weight = self.direction[good], np.sqrt(np.sin(self.polar[good]))
        basis = np.stack([n[:, 0] ** i * n[:, 1] ** j * n[:, 2] ** (d - i - j) for d in (degree, degree - 1)
                          for i in range(d + 1) for j in range(d + 1 - i)], axis=1)
        solution = np.linalg.lstsq(basis * weight[:, None], self.r[good] * weight, rcond=None)[0]
        rest = self.r[good] - basis @ solution
        return float(np.sqrt(np.average(rest ** 2, weights=weight ** 2)) / np.average(self.r[good], weights=weight ** 2))

    def flatness(self, upper):
        """c of the face's best z = z0 -+ c s(r) over r < 0.65 of the half width, s being a sphere's sagitta: 1 for a sphere,
        height over width for an ellipsoid, 0 flat, negative: bulging inwards."""
        good = np.isfinite(self.r)
        p, weight = self.points[good] - self.centre, np.sqrt(np.sin(self.polar[good]))
        out = np.hypot(p[:, 0], p[:, 1])
        half = out.max()
        face = ((p[:, 2] > 0) == upper) & (out < 0.65 * half)
        sagitta = half - np.sqrt(half ** 2 - out[face] ** 2)
        basis = np.stack([np.ones(face.sum()), sagitta], axis=1) * weight[face, None]
        slope = np.linalg.lstsq(basis, p[face, 2] * weight[face], rcond=None)[0][1]
        return float(-slope if upper else slope)
