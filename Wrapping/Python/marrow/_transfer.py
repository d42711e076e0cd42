# SPDX-License-Identifier: BSD-3-Clause
"""marrow.transfer: vtkSegmentationTransfer."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Iterable, List, Optional, TypedDict, Union, Unpack

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from ._arrays import Array, lines_of, named, points_of
from ._hints import Hints, connect_hints
from ._mesh import Mesh, MeshLike, Segments, polydata_of, set_segments
from ._parameters import set_parameters
from ._progress import ProgressCallback, Watch
from ._run import polydata_output, run
from ._skeleton import Skeleton
from .vtk import vtkSegmentationTransfer


@dataclass(frozen=True, eq=False)
class Boundaries:
    """Closed lines between the segments of one mesh."""

    polydata: vtkPolyData
    """A polyline per boundary."""

    @property
    def ids(self) -> Array:
        """(b,) int: lines of the same id correspond on source and target, point by point."""
        return named(self.polydata.GetCellData(), "BoundaryId")

    @property
    def loops(self) -> List[Array]:
        """b arrays (k, 3) float: the points of each line; the last one is the first again."""
        points = points_of(self.polydata)
        return [points[line] for line in lines_of(self.polydata)]

    @property
    def segments(self) -> Array:
        """(b, 2) int: the segments on the left and on the right, seen from outside."""
        cells = self.polydata.GetCellData()
        return np.column_stack([named(cells, "FirstSegmentId"), named(cells, "SecondSegmentId")])


@dataclass(frozen=True, eq=False)
class Transfer(Mesh):
    """The target mesh with the segments carried to it: what marrow.transfer returns."""

    source_boundaries: Boundaries
    """All boundaries of the source."""

    target_boundaries: Boundaries
    """Those that were carried to the target."""

    @property
    def confidence(self) -> Array:
        """(m,) float: how sure each face's segment is, from 0 to 1."""
        return named(self.polydata.GetCellData(), "SegmentConfidence")


class TransferParameters(TypedDict, total=False):
    answer_index: Optional[int]
    keep_target_segments: Optional[bool]
    strict_boundaries: Optional[bool]
    theta: Optional[float]
    kernel: Optional[float]
    lambda_: Optional[float]
    search_region: Optional[float]


def transfer(
    source: Union[MeshLike, Skeleton],
    target: Union[MeshLike, Skeleton],
    *,
    segments: Segments = None,
    hints: Optional[Hints] = None,
    forbidden: Optional[Hints] = None,
    carried: Optional[Iterable[int]] = None,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
    **parameters: Unpack[TransferParameters],
) -> Transfer:
    """Carries the segments of one mesh to another that is like it.

    Parameters
    ----------
    source, target
        Meshes; or skeletons, from marrow.skeleton or marrow.correspond, which are then not computed
        again, nor is their correspondence.
    segments : (m,) int, or the name of a cell array
        The segment of each face of the source. Default: the source's own, the array "SegmentId".
    hints : pairs of int, default: none
        (source point, target point): points that are of the same part; before all other evidence.
        One pair on the two heads turns an animal round that was matched back to front.
    forbidden : pairs of int, default: none
        The same for points whose parts must not be taken for each other.
    answer_index : int, 0 or more, default: 0
        Which answer to how the skeletons match is taken: 0 the likeliest, 1 the next, and so on.
    carried : ints, default: all
        The segments to carry; faces that would get another have the segment -1, which is none.
    keep_target_segments : bool, default: False
        Keep the segments that the target has already, where they are not -1.
    strict_boundaries : bool, default: False
        Carry only the boundaries of the paper, those around one branch.
    theta : float, 1 to 100, default: 1.5
        With strict_boundaries, how far a change of thickness must stand out to be a landmark on a branch.
    kernel : float, 0.005 to 0.5, default: 0.05
        With strict_boundaries, smoothing of the thickness along a branch, over the branch's length.
    lambda_ : float, 0 to pi, radians, default: 0.1
        With strict_boundaries, vertices whose dihedral angles differ by less are the same feature to the
        snake.
    search_region : float, 0 to 0.2, default: 0.02
        With strict_boundaries, how far the snake may move a boundary, over the target's longest geodesic
        distance.
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    Transfer
        The target with a segment for each of its faces; see also the class vtkSegmentationTransfer.

    Raises
    ------
    Error
        If a mesh, its segments or a hint cannot be used.

    Warns
    -----
    MarrowWarning
        If a segment is lost, the skeletons are of no help, or no answer keeps to the hints.

    Examples
    --------
    >>> import marrow
    >>> labelled = marrow.transfer(marrow.creature("biped"), marrow.creature("biped", seed=7, pose=0.5))
    >>> sorted(set(labelled.segments.tolist()))
    [0, 1, 2, 3, 4, 5, 6]
    """
    algorithm = vtkSegmentationTransfer()
    set_parameters(algorithm, transfer, TransferParameters, parameters)
    for segment in carried or ():
        algorithm.AddCarriedSegment(segment)
    meshes = []
    for port, side in enumerate((source, target)):
        mesh = polydata_of(side.mesh if isinstance(side, Skeleton) else side)
        if port == 0:
            algorithm.SetInputArrayToProcess(
                0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, set_segments(mesh, segments))
        algorithm.SetInputData(port, mesh)
        meshes.append(mesh)
        if isinstance(side, Skeleton):
            algorithm.SetInputData(2 + port, side.polydata)
    connect_hints(algorithm, (4, 5), (meshes[0], meshes[1]), hints, forbidden)
    with Watch("transfer", progress, progress_bar) as watch:
        run(algorithm, "transfer", watch)
    return Transfer(
        polydata_output(algorithm, 0),
        Boundaries(polydata_output(algorithm, 1)),
        Boundaries(polydata_output(algorithm, 2)),
    )
