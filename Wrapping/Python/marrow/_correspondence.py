# SPDX-License-Identifier: BSD-3-Clause
"""marrow.correspond: vtkSkeletonCorrespondence."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, List, Literal, NamedTuple, Optional, TypedDict, Union, Unpack

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkTable

from ._arrays import Array, named, view
from ._hints import Hints, connect_hints
from ._mesh import MeshLike
from ._parameters import set_parameters
from ._progress import ProgressCallback, Watch
from ._run import polydata_output, run
from ._skeleton import Skeleton, skeleton_of
from .vtk import vtkSkeletonCorrespondence


class Match(NamedTuple):
    """The same part on both sides; several indices where nodes or branches were merged."""

    id: int
    """CorrespondenceId or BranchCorrespondenceId of the data contract."""
    source: Array
    """Indices on the source: of nodes, or of branches in the order of their chain."""
    target: Array
    """Indices on the target."""


@dataclass(frozen=True, eq=False)
class Correspondence:
    """Which parts of two skeletons are the same: what marrow.correspond returns."""

    source: Skeleton
    """The source's skeleton; its polydata has the correspondence's arrays."""

    target: Skeleton
    """The target's."""

    table: vtkTable
    """One row per answer that was found, the best first."""

    @property
    def nodes(self) -> List[Match]:
        """Matched terminals and junctions."""
        source, target = (
            named(side.polydata.GetPointData(), "CorrespondenceId")
            for side in (self.source, self.target)
        )
        return [
            Match(int(number), np.flatnonzero(source == number), np.flatnonzero(target == number))
            for number in np.unique(source[source >= 0])
        ]

    @property
    def branches(self) -> List[Match]:
        """Matched branches."""
        ids, order = (
            [named(side.polydata.GetCellData(), name) for side in (self.source, self.target)]
            for name in ("BranchCorrespondenceId", "BranchCorrespondenceOrder")
        )

        def chain(side: int, number: int) -> Array:
            members = np.flatnonzero(ids[side] == number)
            return members[np.argsort(order[side][members])]

        return [
            Match(int(number), chain(0, number), chain(1, number))
            for number in np.unique(ids[0][ids[0] >= 0])
        ]

    @property
    def confidence(self) -> float:
        """The share of terminals that may be expected to be matched with the same part, 0 to 1."""
        fields = self.source.polydata.GetFieldData()
        return float(named(fields, "CorrespondenceConfidence")[0])

    @property
    def answers(self) -> Dict[str, Array]:
        """The table's columns; row i is what leaf_index=i gives."""
        rows = self.table.GetRowData()
        return {
            rows.GetArrayName(i): view(rows.GetAbstractArray(i))
            for i in range(rows.GetNumberOfArrays())
        }


class CorrespondenceParameters(TypedDict, total=False):
    matcher: Optional[Literal["correspondence_tree", "electors_voting"]]
    leaf_index: Optional[int]
    global_selection: Optional[bool]
    junction_threshold: Optional[float]
    merge_distance: Optional[float]
    cluster_distance: Optional[float]
    descriptor_pieces: Optional[int]
    centricity_tolerance: Optional[float]
    path_tolerance: Optional[float]
    spatial_tolerance: Optional[float]


def correspond(
    source: Union[MeshLike, Skeleton],
    target: Union[MeshLike, Skeleton],
    *,
    hints: Optional[Hints] = None,
    forbidden: Optional[Hints] = None,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
    **parameters: Unpack[CorrespondenceParameters],
) -> Correspondence:
    """Which nodes and branches of two skeletons are the same parts.

    Parameters
    ----------
    source, target
        Skeletons; of meshes, the skeletons are computed by the defaults of marrow.skeleton.
    hints : pairs of int, default: none
        (source point, target point): points of the meshes that are of the same part. Answers that
        keep to them come first.
    forbidden : pairs of int, default: none
        The same for points whose parts must not be taken for each other.
    matcher : "correspondence_tree" or "electors_voting", default: "correspondence_tree"
        The method; the second is there for comparisons.
    leaf_index : int, 0 or more, default: 0
        Which answer to give; 0 is the best.
    global_selection : bool, default: True
        Judge the answers by the whole skeletons, or by the junctions only, as the paper does.
    junction_threshold : float, 0 to 1, default: 0.02
        Junctions match at once up to this cost.
    merge_distance : float, 0 to 1, default: 0.075
        Junctions no further apart may be merged; over the diagonal of the bounding box.
    cluster_distance : float, 0 to 10, default: 0.1
        Branches of a junction are similar up to this difference of their thickness.
    descriptor_pieces : int, 1 to 256, default: 8
        In how many pieces the thickness along a branch is described.
    centricity_tolerance : float, 0 to 1, default: 0.4
        Electors voting: nodes whose agd differs by more do not match.
    path_tolerance : float, 0 to 1, default: 0.3
        Electors voting: the same for the lengths of the paths between nodes, over the longest.
    spatial_tolerance : float, 0 to 2, default: 0.35
        Electors voting: the share of the nodes' spread that may remain after the best alignment.
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    Correspondence
        Both skeletons, what of them is matched, and a table of all answers; see also the class
        vtkSkeletonCorrespondence.

    Raises
    ------
    Error
        If a mesh or skeleton cannot be used.

    Examples
    --------
    >>> import marrow
    >>> pair = marrow.correspond(marrow.creature("biped"), marrow.creature("biped", pose=0.5, seed=7))
    >>> len([match for match in pair.nodes if match.source[0] in pair.source.terminals])
    5
    """
    algorithm = vtkSkeletonCorrespondence()
    set_parameters(algorithm, correspond, CorrespondenceParameters, parameters)
    with Watch("correspond", progress, progress_bar) as watch:
        sides = (
            skeleton_of(source, "correspond: source", watch, 0.0, 0.45),
            skeleton_of(target, "correspond: target", watch, 0.45, 0.9),
        )
        for port, side in enumerate(sides):
            algorithm.SetInputData(port, side.polydata)
        meshes = (sides[0].mesh.polydata, sides[1].mesh.polydata)
        connect_hints(algorithm, (2, 3), meshes, hints, forbidden)
        run(algorithm, "correspond", watch, 0.9, 1.0)
    table = vtkTable()
    table.ShallowCopy(algorithm.GetOutputDataObject(2))
    matched = [Skeleton(polydata_output(algorithm, i), side.mesh) for i, side in enumerate(sides)]
    return Correspondence(matched[0], matched[1], table)
