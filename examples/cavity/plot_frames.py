"""The pictures of plot.py that need frames/*.vti: the cut x = 0 and the cavity's surface."""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

UM = 1e-6


def frame_list(run):
    """[(path, time in ns)] of frames/grid.pvd."""
    collection = run / "frames" / "grid.pvd"
    if not collection.exists():
        raise ValueError(f"{collection} is missing; the run had no frames")
    root = ElementTree.parse(collection).getroot()
    return [(collection.parent / e.get("file"), 1e9 * float(e.get("timestep"))) for e in root.iter("DataSet")]


def choose(frames, count):
    """`count` of them, evenly spaced, the last one included and the first one not."""
    picked = np.unique(np.round(np.linspace(0, len(frames) - 1, count + 1)).astype(int))
    return [frames[i] for i in picked[1:]] or frames


def read(path):
    reader = vtk.vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def slice_at_x0(image):
    """y and z of the nodes, um, and the fields on the plane x = 0 as arrays [z, y]."""
    nx, ny, nz = image.GetDimensions()
    spacing, bounds = image.GetSpacing(), image.GetBounds()
    i = int(round((0 - bounds[0]) / spacing[0]))
    fields = {}
    for name in ("volume_fraction", "pressure", "velocity", "temperature"):
        array = image.GetPointData().GetArray(name)
        if array is not None:
            values = vtk_to_numpy(array).reshape(nz, ny, nx, -1)[:, :, i, :].astype(float)
            fields[name] = values[..., -1]  # of the velocity: v_z
    y, z = (bounds[2 * a] / UM + spacing[a] / UM * np.arange(n) for a, n in ((1, ny), (2, nz)))
    return y, z, fields


def extended(values, known):
    """Values carried a few nodes into the void, so that interpolation at the surface sees material only."""
    values, known = np.where(known, values, 0), known.astype(float)
    for _ in range(4):
        padded_v, padded_k = np.pad(values * known, 1), np.pad(known, 1)
        box = [(i, j) for i in range(3) for j in range(3)]
        n, m = values.shape
        sum_v = sum(padded_v[i:i + n, j:j + m] for i, j in box)
        sum_k = sum(padded_k[i:i + n, j:j + m] for i, j in box)
        fresh = (known == 0) & (sum_k > 0)
        values[fresh] = sum_v[fresh] / sum_k[fresh]
        known[fresh] = 1
    return values


def refined(values, factor=6):
    """Bilinear interpolation on a finer mesh."""
    for _ in range(2):
        n = len(values)
        u = np.linspace(0, n - 1, (n - 1) * factor + 1)
        i = np.minimum(u.astype(int), n - 2)
        part = (u - i)[:, None]
        values = (values[i] * (1 - part) + values[i + 1] * part).T
    return values


def panel_fields(frames):
    """Per frame: (time, extent, {label: image})."""
    panels = []
    for path, time in frames:
        y, z, f = slice_at_x0(read(path))
        known = f["volume_fraction"] > 0.05
        inside = refined(f["volume_fraction"]) >= 0.5
        show = {}
        for label, name, scale in (("v_z  (m/s)", "velocity", 1), ("P  (GPa)", "pressure", 1e-9),
                                   ("T  (K)", "temperature", 1)):
            if name in f:
                show[label] = np.where(inside, scale * refined(extended(f[name], known)), np.nan)
        panels.append((time, (y[0], y[-1], z[0], z[-1]), show))
    return panels


def draw_cut(run, title, file):
    panels = panel_fields(choose(frame_list(run), 4))
    labels = list(panels[0][2])
    figure, grid = plt.subplots(len(labels), len(panels), figsize=(3.6 * len(panels) + 1, 4.3 * len(labels)),
                                squeeze=False, layout="constrained", sharex=True, sharey=True)
    for row, label in zip(grid, labels):
        values = np.concatenate([show[label][np.isfinite(show[label])] for _, _, show in panels])
        low, high = np.percentile(values, (0.05, 99.95))
        colours = {"cmap": "inferno", "vmin": low, "vmax": high}
        if low < 0 < high:
            limit = max(-low, high)
            colours = {"cmap": "RdBu_r", "vmin": -limit, "vmax": limit}
        for axes, (time, extent, show) in zip(row, panels):
            image = axes.imshow(show[label], origin="lower", extent=extent, interpolation="nearest", **colours)
            axes.set_facecolor("#dddddd")
            axes.set_title(f"{label.split()[0]}, {time:.2f} ns")
        row[0].set_ylabel("z  (µm)")
        figure.colorbar(image, ax=row.tolist(), label=label, extend="both", fraction=0.03)
    for axes in grid[-1]:
        axes.set_xlabel("y  (µm)")
    figure.suptitle("Cut x = 0 (wall at z = 0; grey: no material)\n" + title)
    figure.savefig(file, dpi=100)
    plt.close(figure)


def cavity_surface(image, centre_z):
    """The piece of the isosurface volume_fraction = 1/2 nearest to the cavity's first centre, in um."""
    contour = vtk.vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "volume_fraction")
    contour.SetValue(0, 0.5)
    contour.InterpolateAttributesOn()
    piece = vtk.vtkPolyDataConnectivityFilter()
    piece.SetInputConnection(contour.GetOutputPort())
    piece.SetExtractionModeToClosestPointRegion()
    piece.SetClosestPoint(0, 0, centre_z * UM)
    scale = vtk.vtkTransform()
    scale.Scale(1 / UM, 1 / UM, 1 / UM)
    scaled = vtk.vtkTransformPolyDataFilter()
    scaled.SetTransform(scale)
    scaled.SetInputConnection(piece.GetOutputPort())
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(scaled.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    surface = normals.GetOutput()
    if surface.GetNumberOfPoints() == 0:
        raise ValueError("there is no surface volume_fraction = 1/2")
    return surface


def render(surface, limits, focus, half_height, size=560):
    """An image (rows, columns, 3) of the surface coloured by v_z, in parallel projection."""
    colours = vtk.vtkLookupTable()
    colours.SetNumberOfTableValues(256)
    for i, rgba in enumerate(plt.get_cmap("RdBu_r")(np.linspace(0, 1, 256))):
        colours.SetTableValue(i, *rgba)
    colours.SetRange(*limits)
    colours.SetVectorModeToComponent()
    colours.SetVectorComponent(2)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("velocity")
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.5)
    actor.GetProperty().SetDiffuse(0.55)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half_height)
    camera.SetFocalPoint(0, 0, focus)
    camera.SetPosition(70, -100, focus + 35)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.Update()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(size, size, -1)[::-1]


def draw_surface(run, title, centre_z, file):
    frames = frame_list(run)
    chosen = frames[:1] + choose(frames, 4) if len(frames) > 4 else frames
    surfaces = [cavity_surface(read(path), centre_z) for path, _ in chosen]
    speeds = np.concatenate([vtk_to_numpy(s.GetPointData().GetArray("velocity"))[:, 2] for s in surfaces])
    limit = float(f"{np.percentile(np.abs(speeds), 99.5):.1g}") or 1
    bounds = np.array([s.GetBounds() for s in surfaces])
    low, high = bounds[:, 4].min(), bounds[:, 5].max()
    half_height = 0.62 * max(high - low, (bounds[:, 1] - bounds[:, 0]).max())
    figure, grid = plt.subplots(1, len(chosen), squeeze=False, layout="constrained",
                                figsize=(3.2 * len(chosen) + 1, 4.4))
    for axes, surface, (_, time), box in zip(grid[0], surfaces, chosen, bounds):
        e = half_height
        axes.imshow(render(surface, (-limit, limit), (low + high) / 2, half_height), extent=(-e, e, -e, e))
        axes.plot([-0.9 * e, -0.9 * e + 5], [-0.92 * e] * 2, color="black", lw=3)
        axes.text(-0.9 * e + 2.5, -0.9 * e, "5 µm", ha="center", va="bottom")
        axes.set_title(f"{time:.2f} ns\nx {box[0]:.1f}..{box[1]:.1f}, z {box[4]:.1f}..{box[5]:.1f} µm", fontsize=10)
        axes.axis("off")
    scale = plt.cm.ScalarMappable(plt.Normalize(-limit, limit), "RdBu_r")
    figure.colorbar(scale, ax=grid[0].tolist(), label="v_z  (m/s)", fraction=0.02, extend="both")
    figure.suptitle("Surface of the cavity (volume fraction 1/2), seen from the side, z upwards\n" + title)
    figure.savefig(file, dpi=110)
    plt.close(figure)


if __name__ == "__main__":
    try:
        draw_surface(pathlib.Path(sys.argv[1]), sys.argv[2], float(sys.argv[3]), sys.argv[4])
    except (ValueError, OSError) as reason:
        sys.exit(str(reason))
