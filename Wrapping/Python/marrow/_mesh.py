# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as they go in and come out."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._arrays import Array, faces_of, named, points_of, polydata_from, to_vtk
from ._messages import Error

SEGMENT_ID = "SegmentId"


@dataclass(frozen=True, eq=False)
class Mesh:
    """A mesh: a vtkPolyData, and numpy's view on it.

    The arrays are read-only views on the memory of VTK's: take a copy to change one.
    """

    polydata: vtkPolyData
    """The mesh with all of its arrays."""

    @property
    def points(self) -> Array:
        """(n, 3) float: positions of the vertices."""
        return points_of(self.polydata)

    @property
    def faces(self) -> Array:
        """(m, k) int: the vertices of each face, counter-clockwise seen from outside; k is 3 for
        triangles. Where some faces have fewer corners than others, -1 follows theirs."""
        return faces_of(self.polydata)

    @property
    def note(self) -> str:
        """What was mended to work on the mesh, in words: "merged 14,220 equal points, turned 3
        faces"; empty if nothing was. The mesh itself is as it was."""
        said = self.polydata.GetFieldData().GetAbstractArray("WorkingSurfaceNote")
        return str(said.GetValue(0)) if said is not None else ""

    @property
    def segments(self) -> Optional[Array]:
        """(m,) int: the segment of each face; None if the mesh has none."""
        if not self.polydata.GetCellData().HasArray(SEGMENT_ID):
            return None
        return named(self.polydata.GetCellData(), SEGMENT_ID)

    def with_segments(self, segments: ArrayLike) -> Mesh:
        """The same mesh with these segments, (m,) int; this one is left as it is."""
        polydata = polydata_of(self)
        array = to_vtk(segments, SEGMENT_ID)
        if (array.GetNumberOfTuples(), array.GetNumberOfComponents()) != (
            polydata.GetNumberOfCells(), 1
        ):
            raise Error(
                f"segments must have the shape ({polydata.GetNumberOfCells()},), one per face, "
                f"not {np.shape(segments)}."
            )
        polydata.GetCellData().AddArray(array)
        return Mesh(polydata)


MeshLike = Union[vtkPolyData, Mesh, Tuple[ArrayLike, ArrayLike]]
"""What is taken for a mesh: a vtkPolyData (a subclass too), a Mesh, or a pair (points, faces) of
arrays of the shapes (n, 3), float, and (m, k), int, as Mesh.faces says."""


def polydata_of(mesh: MeshLike) -> vtkPolyData:
    """The mesh as a vtkPolyData to which arrays may be added: the user's is not touched."""
    if isinstance(mesh, Mesh):
        mesh = mesh.polydata
    if isinstance(mesh, vtkPolyData):
        copy = vtkPolyData()
        copy.ShallowCopy(mesh)
        return copy
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return polydata_from(*mesh)
    raise TypeError(
        "a mesh is a vtkPolyData, a marrow.Mesh or a pair (points, faces) of arrays, "
        f"not {type(mesh).__name__}"
    )


Segments = Union[str, ArrayLike, None]
"""Where a mesh's segments are: (m,) int, one per face; the name of a cell array; None for the cell
array "SegmentId"."""


def set_segments(polydata: vtkPolyData, segments: Segments) -> str:
    """Puts segments on the cells if they are values; returns the name of the cell array."""
    if segments is None:
        return SEGMENT_ID
    if isinstance(segments, str):
        return segments
    polydata.GetCellData().AddArray(to_vtk(segments, SEGMENT_ID))
    return SEGMENT_ID
