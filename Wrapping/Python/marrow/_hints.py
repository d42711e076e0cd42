# SPDX-License-Identifier: BSD-3-Clause
"""Pairs of points of two meshes, as the filters take them."""
from __future__ import annotations

from typing import Optional, Sequence, Tuple

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from ._arrays import to_vtk
from ._messages import Error

Hints = Sequence[Tuple[int, int]]
"""Pairs of a point of the source and a point of the target, by their numbers, from 0."""


def connect_hints(
    algorithm: vtkAlgorithm,
    ports: Tuple[int, int],
    meshes: Tuple[vtkPolyData, vtkPolyData],
    hints: Optional[Hints],
    forbidden: Optional[Hints],
) -> None:
    """Connects both lists of pairs, if there are any, to the filter's ports for hints."""
    pairs = [*(hints or ()), *(forbidden or ())]
    if not pairs:
        return
    for side, (port, mesh, name) in enumerate(zip(ports, meshes, ("source", "target"))):
        points = vtkPoints()
        points.SetDataTypeToDouble()
        for pair in pairs:
            point = int(pair[side])
            if not 0 <= point < mesh.GetNumberOfPoints():
                raise Error(
                    f"hints: the {name} has no point {point}, "
                    f"only 0 to {mesh.GetNumberOfPoints() - 1}."
                )
            points.InsertNextPoint(mesh.GetPoint(point))
        polydata = vtkPolyData()
        polydata.SetPoints(points)
        if side == 0:
            flags = np.repeat([0, 1], [len(hints or ()), len(forbidden or ())])
            polydata.GetPointData().AddArray(to_vtk(flags, "Forbidden"))
        algorithm.SetInputDataObject(port, polydata)
