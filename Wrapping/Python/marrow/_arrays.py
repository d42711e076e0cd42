# SPDX-License-Identifier: BSD-3-Clause
"""VTK's arrays seen by numpy, and numpy's given to VTK."""
from __future__ import annotations

from typing import Any, List

import numpy as np
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import (
    get_vtk_array_type,
    numpy_to_vtk,
    numpy_to_vtkIdTypeArray,
    vtk_to_numpy,
)
from vtkmodules.vtkCommonCore import vtkAbstractArray, vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkFieldData, vtkPolyData

from ._messages import Error

Array = NDArray[Any]


def view(array: vtkAbstractArray) -> Array:
    """The array's own memory. Filters share arrays between input and output, so nobody may write."""
    values: Array = vtk_to_numpy(array)
    values.flags.writeable = False
    return values


def named(data: vtkFieldData, name: str) -> Array:
    """A view on the array of that name, which must be there."""
    array = data.GetAbstractArray(name)
    if array is None:
        have = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        raise Error(f"there is no array {name!r}; there are {', '.join(map(repr, have)) or 'none'}.")
    return view(array)


def points_of(polydata: vtkPolyData) -> Array:
    points = polydata.GetPoints()
    return view(points.GetData()) if points is not None else np.empty((0, 3))


def faces_of(polydata: vtkPolyData) -> Array:
    """A row a face, as wide as the face of most corners; -1 after the corners of a smaller one."""
    polygons = polydata.GetPolys()
    count = polygons.GetNumberOfCells()
    if count == 0:
        return np.empty((0, 3), dtype=np.int64)
    if count != polydata.GetNumberOfCells():
        raise Error("the mesh has cells that are no polygons: keep its polygons alone.")
    corners = view(polygons.GetConnectivityArray())
    width = polygons.IsHomogeneous()
    if width > 0:
        return corners.reshape(-1, width)
    sizes = np.diff(view(polygons.GetOffsetsArray()))
    faces = np.full((count, sizes.max()), -1, dtype=np.int64)
    faces[np.arange(sizes.max()) < sizes[:, None]] = corners
    faces.flags.writeable = False
    return faces


def lines_of(polydata: vtkPolyData) -> List[Array]:
    """Per polyline the indices of its points."""
    lines = polydata.GetLines()
    if lines.GetNumberOfCells() == 0:
        return []
    offsets = view(lines.GetOffsetsArray())
    return np.split(view(lines.GetConnectivityArray()), offsets[1:-1])


def to_vtk(values: ArrayLike, name: str) -> vtkDataArray:
    """A copy as an array of VTK's."""
    array = np.ascontiguousarray(values)
    if array.ndim > 2:
        raise Error(f"{name}: the values have the shape {array.shape}, more than two dimensions.")
    if array.dtype == bool:
        array = array.astype(np.uint8)
    try:
        kind = get_vtk_array_type(array.dtype)
    except TypeError:
        raise TypeError(f"{name}: values of type {array.dtype} are no numbers") from None
    copy = numpy_to_vtk(array, deep=True, array_type=kind)
    copy.SetName(name)
    return copy


def polydata_from(points: ArrayLike, faces: ArrayLike) -> vtkPolyData:
    """The mesh of points (n, 3) and faces (m, k), copied; see faces_of."""
    corners, polygons = np.asarray(points), np.asarray(faces)
    if corners.ndim != 2 or corners.shape[1] != 3:
        raise Error(f"points must have the shape (n, 3), not {corners.shape}.")
    if polygons.ndim != 2 or polygons.shape[1] < 3:
        raise Error(f"faces must have the shape (m, 3) or (m, k > 3), not {polygons.shape}.")
    if not np.issubdtype(polygons.dtype, np.integer):
        raise TypeError(f"faces must be integers, not {polygons.dtype}")
    if corners.dtype != np.float32:
        corners = corners.astype(np.float64)
    sizes = polygons.shape[1] - (np.cumprod(polygons[:, :2:-1] == -1, axis=1)).sum(axis=1)
    used = np.arange(polygons.shape[1]) < sizes[:, None]
    wrong = (used & ((polygons < 0) | (polygons >= len(corners)))).any(axis=1)
    if wrong.any():
        raise Error(
            f"{wrong.sum()} faces name a point that does not exist, the first is face "
            f"{wrong.argmax()}: indices run from 0 to {len(corners) - 1}."
        )
    vtk_points = vtkPoints()
    vtk_points.SetData(to_vtk(corners, "Points"))
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64), deep=True),
        numpy_to_vtkIdTypeArray(polygons[used].astype(np.int64), deep=True))
    polydata = vtkPolyData()
    polydata.SetPoints(vtk_points)
    polydata.SetPolys(cells)
    return polydata
