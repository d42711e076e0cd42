# SPDX-License-Identifier: BSD-3-Clause
"""marrow.cut: vtkMarrowSegmentCutter."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

from vtkmodules.vtkCommonDataModel import vtkDataObject

from ._arrays import Array, named
from ._mesh import Mesh, MeshLike, Segments, polydata_of, set_segments
from ._progress import ProgressCallback, Watch
from ._run import polydata_output, run
from .vtk import vtkMarrowSegmentCutter


@dataclass(frozen=True, eq=False)
class Cut(Mesh):
    """A mesh cut along its segments: what marrow.cut returns."""

    @property
    def original_faces(self) -> Array:
        """(m,) int: the face of the mesh that each face is a piece of."""
        return named(self.polydata.GetCellData(), "vtkOriginalCellIds")


def cut(
    mesh: MeshLike,
    *,
    segments: Segments = None,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
) -> Cut:
    """Cuts a labelled mesh along smooth boundaries of its segments.

    Parameters
    ----------
    mesh
        A mesh with segments, such as marrow.transfer returns.
    segments : (m,) int, or the name of a cell array
        The segment of each face. Default: the mesh's own, the array "SegmentId".
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    Cut
        The faces that no boundary crosses, and the pieces of the others, each with its segment; see also
        the class vtkMarrowSegmentCutter. The points of the mesh keep their numbers.

    Raises
    ------
    Error
        If the mesh or its segments cannot be used.

    Examples
    --------
    >>> import marrow
    >>> biped = marrow.creature("biped")
    >>> smooth = marrow.cut(biped)
    >>> len(smooth.faces) > len(biped.faces)
    True
    """
    algorithm = vtkMarrowSegmentCutter()
    polydata = polydata_of(mesh)
    algorithm.SetInputArrayToProcess(
        0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, set_segments(polydata, segments))
    algorithm.SetInputData(polydata)
    with Watch("cut", progress, progress_bar) as watch:
        run(algorithm, "cut", watch)
    return Cut(polydata_output(algorithm, 0))
