"""Renders surfaces with VTK into images for matplotlib: lengths in um, z upwards, parallel projection."""

import numpy as np
import matplotlib.pyplot as plt
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import shapes


def part(grid, x_min=-np.inf, z_max=np.inf):
    """A grid cut down to x >= x_min and z <= z_max, as an object with the same arrays."""
    x, z = grid.x >= x_min - 1e-6, grid.z <= z_max + 1e-6
    cut = type("Part", (), {"x": grid.x[x], "y": grid.y, "z": grid.z[z], "h": grid.h})()
    for name in ("fraction", "rho", "p", "t", "vz"):
        setattr(cut, name, getattr(grid, name)[z][:, :, x])
    cut.solid = cut.fraction >= 0.5
    return cut


def tiled(grid):
    """Two by two periods side by side."""
    period = grid.x[-1] - grid.x[0]
    wide = type("Part", (), {"z": grid.z, "h": grid.h})()
    wide.x, wide.y = (np.concatenate([places, places[1:] + period]) for places in (grid.x, grid.y))
    for name in ("fraction", "p", "t", "vz"):
        twice = np.concatenate([getattr(grid, name), getattr(grid, name)[:, :, 1:]], axis=2)
        setattr(wide, name, np.concatenate([twice, twice[:, 1:]], axis=1))
    wide.solid = wide.fraction >= 0.5
    return wide


def level_surface(grid, name, level, steep=0.0):
    """The surface name = level in the metal, where the field changes by at least `steep` per um."""
    field = shapes.carried_into_void(getattr(grid, name), grid.solid)
    fields = {"fraction": grid.fraction, name: field}
    if steep > 0:
        fields["slope"] = np.sqrt(sum(part ** 2 for part in np.gradient(field, grid.h)))
    surface = shapes.kept(shapes.isosurface(shapes.image_of(grid, **fields), name, level), "fraction", 0.5)
    return shapes.kept(surface, "slope", steep) if steep > 0 else surface


def cavity_surface(grid, centre_z):
    """The piece of the surface of the metal that is nearest to a point on the axis."""
    piece = vtk.vtkPolyDataConnectivityFilter()
    piece.SetInputData(shapes.isosurface(shapes.image_of(grid, fraction=grid.fraction), "fraction", 0.5))
    piece.SetExtractionModeToClosestPointRegion()
    piece.SetClosestPoint(0, 0, centre_z)
    piece.Update()
    return piece.GetOutput()


def all_surfaces(grid):
    """The surface of the metal, wherever it is."""
    return shapes.isosurface(shapes.image_of(grid, fraction=grid.fraction), "fraction", 0.5)


def face(grid, name):
    """The plane x = least x, where there is metal, carrying a field."""
    field = shapes.carried_into_void(getattr(grid, name), grid.solid)
    plane = vtk.vtkImageDataGeometryFilter()
    plane.SetInputData(shapes.image_of(grid, fraction=grid.fraction, **{name: field}))
    plane.SetExtent(0, 0, 0, len(grid.y) - 1, 0, len(grid.z) - 1)
    plane.Update()
    return shapes.kept(plane.GetOutput(), "fraction", 0.5)


def box(grid):
    """The edges of the grid's box."""
    outline = vtk.vtkOutlineFilter()
    outline.SetInputData(shapes.image_of(grid, fraction=grid.fraction))
    outline.Update()
    return outline.GetOutput()


def actor(surface, colour=(0.7, 0.7, 0.7), opacity=1.0, field=None, limits=(0, 1), colours="RdBu_r", smooth=True):
    """A surface in one colour, or coloured by a field on it."""
    mapper = vtk.vtkPolyDataMapper()
    if smooth and surface.GetNumberOfCells() > 0 and surface.GetNumberOfPolys() > 0:
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputData(surface)
        normals.SplittingOff()
        mapper.SetInputConnection(normals.GetOutputPort())
    else:
        mapper.SetInputData(surface)
    thing = vtk.vtkActor()
    thing.SetMapper(mapper)
    if field is None:
        mapper.ScalarVisibilityOff()
        thing.GetProperty().SetColor(*colour)
    else:
        scale = vtk.vtkLookupTable()
        scale.SetNumberOfTableValues(256)
        for i, rgba in enumerate(plt.get_cmap(colours)(np.linspace(0, 1, 256))):
            scale.SetTableValue(i, *rgba)
        scale.SetRange(*limits)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(field)
        mapper.SetLookupTable(scale)
        mapper.UseLookupTableScalarRangeOn()
    thing.GetProperty().SetOpacity(opacity)
    thing.GetProperty().SetAmbient(0.65)
    thing.GetProperty().SetDiffuse(0.42)
    thing.GetProperty().SetLineWidth(1.5)
    return thing


def render(actors, centre, half_height, towards=(0.65, -1.0, 0.45), size=(520, 520)):
    """An image (rows, columns, 3), seen along -towards, of what lies within half_height of the centre."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetUseDepthPeeling(1)
    renderer.SetMaximumNumberOfPeels(8)
    for thing in actors:
        renderer.AddActor(thing)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half_height)
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(c + 100 * d for c, d in zip(centre, towards)))
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetAlphaBitPlanes(1)
    window.SetMultiSamples(0)
    window.SetSize(2 * size[0], 2 * size[1])
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(2 * size[1], 2 * size[0], -1)[::-1]
    return pixels.reshape(size[1], 2, size[0], 2, -1).mean(axis=(1, 3)).astype(np.uint8)
