#!/usr/bin/python3
"""Reads VTK XML files back with VTK's own readers.

read_vtk.py DIR                  every .vtp, .vti and .pvd below DIR: readable, inline, finite (but for what a whole
                                 body lacks), counts and times agree
read_vtk.py DIR --expect FILE    besides, the values listed in FILE, tab-separated lines:
    file  points|point|cell|field  name  components  type  values...     (type as in the file, e.g. Float32)
    file  lattice                  origin(3) spacing(3) extent(6)
    file  frames                   piece time piece time ...
Exits with 1 and a sentence at the first thing wrong, with 2 if VTK is missing.
"""

import argparse
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

try:
    import numpy
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError as error:
    print(f"read_vtk.py needs VTK's Python module: {error}", file=sys.stderr)
    sys.exit(2)

TYPES = {"Float32": "float32", "Float64": "float64", "UInt32": "uint32", "Int64": "int64"}


class Wrong(Exception):
    """Something does not hold; the text says what."""


def require(holds, sentence):
    if not holds:
        raise Wrong(sentence)


def arrays_of(attributes):
    """Name -> numpy array (tuples, components)."""
    found = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        require(array is not None, "an array is not numeric")
        shape = (array.GetNumberOfTuples(), array.GetNumberOfComponents())
        found[array.GetName()] = vtk_to_numpy(array).reshape(shape)
    return found


def check_inline(path):
    """No appended data, and nothing promised that is not there."""
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        raise Wrong(f"it is not well-formed XML: {error}")
    require(root.find("AppendedData") is None, "it has appended data, which ParaView 5.11 rejects")
    for array in root.iter("DataArray"):
        require(array.get("format") in ("binary", "ascii"), f"the array {array.get('Name')} is not inline")
    return root


def read_grid(path):
    """Reads a .vtp or .vti: {"points" | "point" | "cell" | "field": {name: array}, "lattice": numbers}."""
    declared = [array.get("Name") for part in ("PointData", "CellData") for data in check_inline(path).iter(part)
                for array in data]
    messages = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(messages)
    reader = vtk.vtkXMLPolyDataReader() if path.suffix == ".vtp" else vtk.vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    require(not messages.GetOutput() and reader.GetErrorCode() == 0, "VTK says " + messages.GetOutput().strip())
    data = reader.GetOutput()
    grid = {"point": arrays_of(data.GetPointData()), "cell": arrays_of(data.GetCellData()),
            "field": arrays_of(data.GetFieldData()), "points": {}}
    require(sorted(declared) == sorted([*grid["point"], *grid["cell"]]), f"VTK did not find all of {declared}")
    if path.suffix == ".vtp":
        count = data.GetNumberOfPoints()
        coordinates = vtk_to_numpy(data.GetPoints().GetData()) if count else numpy.zeros((0, 3))
        grid["points"]["Points"] = coordinates.reshape(-1, 3)
        require(data.GetNumberOfVerts() == data.GetNumberOfCells() == count, "not every point has its vertex")
        if count:
            ids = vtk_to_numpy(data.GetVerts().GetConnectivityArray())
            require((ids == numpy.arange(count)).all(), "the vertices are not the points in order")
    else:
        grid["lattice"] = [*data.GetOrigin(), *data.GetSpacing(), *data.GetExtent()]
    check_grid(grid, data.GetNumberOfPoints(), data.GetNumberOfCells())
    return grid


def check_grid(grid, points, cells):
    """Finite numbers, one tuple per point or cell, a time."""
    for kind, count in (("point", points), ("cell", cells), ("points", points), ("field", None)):
        for name, array in grid[kind].items():
            require(count in (None, len(array)), f"the array {name} has {len(array)} tuples for {count} {kind}s")
            bad = numpy.argwhere(~numpy.isfinite(array) & ~lacking(grid, kind, array))
            require(len(bad) == 0, f"the array {name} is not finite at {kind} {bad[0][0] if len(bad) else ''}")
    require("TimeValue" in grid["field"], "it has no TimeValue")


def lacking(grid, kind, array):
    """Where an array is nan because a whole body, told by the array `body`, lacks that field; but not all bodies do."""
    if kind != "point" or "body" not in grid["point"] or numpy.isnan(array).all():
        return numpy.zeros(array.shape, dtype=bool)
    bodies = grid["point"]["body"][:, 0]
    without = [body for body in numpy.unique(bodies) if numpy.isnan(array[bodies == body]).all()]
    return numpy.repeat(numpy.isin(bodies, without)[:, None], array.shape[1], axis=1)


def read_frames(path, grids):
    """Reads a .pvd: [(piece, time)]. Pieces exist, carry the listed times and the same arrays; times increase."""
    entries = [(entry.get("file"), float(entry.get("timestep"))) for entry in check_inline(path).iter("DataSet")]
    require(entries, "it lists no frames")
    first = None
    for (piece, time), (_, before) in zip(entries, [(None, -numpy.inf)] + entries):
        require(not pathlib.PurePath(piece).is_absolute(), f"the path {piece} is not relative")
        target = (path.parent / piece).resolve()
        require(target in grids, f"it lists {piece}, which is missing")
        require(numpy.isfinite(time) and time > before, f"the time {time} of {piece} does not follow {before}")
        grid = grids[target]
        require(grid["field"]["TimeValue"][0, 0] == time, f"{piece} carries another time than {time}")
        names = {(kind, name, array.shape[1]) for kind in ("point", "cell") for name, array in grid[kind].items()}
        first = first or names
        require(names == first, f"{piece} has other arrays than the first frame")
    return entries


def compare(line, root, grids, collections):
    """Compares one line of the expectations."""
    file, kind, *rest = line.rstrip("\n").split("\t")
    path = (root / file).resolve()
    if kind == "frames":
        found = [(piece, time) for piece, time in collections[path]]
        require(found == [(p, float(t)) for p, t in zip(rest[::2], rest[1::2])], f"{file} lists {found}, not {rest}")
        return
    if kind == "lattice":
        require(grids[path]["lattice"] == [float(x) for x in rest], f"{file}: {grids[path]['lattice']}, not {rest}")
        return
    name, components, number, *values = rest
    require(name in grids[path][kind], f"{file} has no {kind} array {name}")
    array = grids[path][kind][name]
    expected = numpy.array(values, dtype=TYPES[number]).reshape(-1, int(components))
    require(len(array) == 0 or array.dtype == expected.dtype, f"{file}: {name} holds {array.dtype}, not {number}")
    require(array.shape == expected.shape, f"{file}: {name} has the shape {array.shape}, not {expected.shape}")
    same = (array == expected) | (numpy.isnan(array) & numpy.isnan(expected))
    require(same.all(), f"{file}: {name} holds {array.tolist()}, not {expected.tolist()}")


def check(root, expect):
    """Reads all files below `root`. Returns how many grids and collections."""
    files = sorted(path.resolve() for path in root.rglob("*") if path.suffix in (".vtp", ".vti", ".pvd"))
    require(files, f"there is no .vtp, .vti or .pvd in {root}")
    grids, collections = {}, {}
    for path in sorted(files, key=lambda path: path.suffix == ".pvd"):
        try:
            if path.suffix == ".pvd":
                collections[path] = read_frames(path, grids)
            else:
                grids[path] = read_grid(path)
        except Wrong as wrong:
            raise Wrong(f"{path}: {wrong}") from None
    lines = expect.read_text().splitlines() if expect else []
    for line in lines:
        compare(line, root, grids, collections)
    return len(grids), len(collections), len(lines)


def main():
    parser = argparse.ArgumentParser(description="Read VTK files back.")
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--expect", type=pathlib.Path, help="a file of values to compare with")
    arguments = parser.parse_args()
    try:
        grids, collections, lines = check(arguments.directory, arguments.expect)
    except Wrong as wrong:
        print(f"read_vtk.py: {wrong}", file=sys.stderr)
        return 1
    print(f"{grids} data files, {collections} collections, {lines} expectations: all read back")
    return 0


if __name__ == "__main__":
    sys.exit(main())
