# SPDX-License-Identifier: BSD-3-Clause
"""marrow.skeleton: vtkMSPSkeleton, and its baseline vtkMarrowMeanCurvatureSkeleton."""
from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import List, Optional, TypedDict, Union, Unpack

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import vtk
from ._arrays import Array, lines_of, named, points_of
from ._measures import Measures
from ._mesh import MeshLike, polydata_of
from ._messages import Error
from ._parameters import set_parameters
from ._progress import ProgressCallback, Watch
from ._run import polydata_output, run


class NodeType(IntEnum):
    """What Skeleton.node_type holds."""

    ISOLATED = 0
    TERMINAL = 1
    REGULAR = 2
    JUNCTION = 3


@dataclass(frozen=True, eq=False)
class Skeleton:
    """The curve skeleton of a mesh, of k nodes and b branches: what marrow.skeleton returns."""

    polydata: vtkPolyData
    """Points are nodes, every branch is a polyline; with all arrays of the data contract."""

    mesh: Measures
    """The mesh that it belongs to, with its measures."""

    @property
    def nodes(self) -> Array:
        """(k, 3) float: positions."""
        return points_of(self.polydata)

    @property
    def node_type(self) -> Array:
        """(k,) int: see NodeType."""
        return named(self.polydata.GetPointData(), "NodeType")

    @property
    def terminals(self) -> Array:
        """Indices of the nodes at the ends of limbs."""
        return np.flatnonzero(self.node_type == NodeType.TERMINAL)

    @property
    def junctions(self) -> Array:
        """Indices of the nodes where branches meet."""
        return np.flatnonzero(self.node_type == NodeType.JUNCTION)

    @property
    def radius(self) -> Array:
        """(k,) float: mean distance from the node to the surface that belongs to it, mesh units."""
        return named(self.polydata.GetPointData(), "Radius")

    @property
    def branches(self) -> List[Array]:
        """b arrays: the indices of the nodes along each branch, from one end to the other."""
        return lines_of(self.polydata)

    @property
    def branch_length(self) -> Array:
        """(b,) float: arc lengths, mesh units."""
        return named(self.polydata.GetCellData(), "BranchLength")

    @property
    def node_of_vertex(self) -> Array:
        """(n,) int: the node that each vertex of the mesh belongs to; -1 if no face uses it."""
        return named(self.mesh.polydata.GetPointData(), "SkeletonNodeId")


class SkeletonParameters(TypedDict, total=False):
    finest_area: Optional[float]
    node_spacing: Optional[float]
    maximum_faces: Optional[int]


class MeanCurvatureSkeletonParameters(TypedDict, total=False):
    quality_speed_tradeoff: Optional[float]
    medially_centered_speed_tradeoff: Optional[float]


def skeleton(
    mesh: MeshLike,
    *,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
    **parameters: Unpack[SkeletonParameters],
) -> Skeleton:
    """The curve skeleton of a mesh, and which vertices belong to which of its nodes.

    Parameters
    ----------
    mesh
        Any mesh. Measures that it has, from marrow.measure, are used.
    finest_area : float, 0 to 1, default: 0.004
        The share of the surface from which a limb gets a branch; less, and fingers get theirs.
    node_spacing : float, 0.001 to 0.5, default: 0.012
        Distance of the nodes along a branch, over the diagonal of the bounding box.
    maximum_faces : int, 0 to 2147483647, default: 30000
        A mesh of more faces is simplified to so many for the skeleton; 0: never.
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    Skeleton
        The nodes and branches, and the mesh with the node of each vertex; see also the class
        vtkMSPSkeleton.

    Raises
    ------
    Error
        If the mesh cannot be used.

    Examples
    --------
    >>> import marrow
    >>> skeleton = marrow.skeleton(marrow.creature("biped"))
    >>> len(skeleton.terminals)  # head, hands, feet
    5
    >>> skeleton.nodes[skeleton.branches[0]].shape[1]
    3
    """
    algorithm = vtk.vtkMSPSkeleton()
    set_parameters(algorithm, skeleton, SkeletonParameters, parameters)
    return watched_skeleton(algorithm, mesh, "skeleton", progress, progress_bar)


def mean_curvature_skeleton(
    mesh: MeshLike,
    *,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
    **parameters: Unpack[MeanCurvatureSkeletonParameters],
) -> Skeleton:
    """The same by CGAL's mean curvature flow, for comparisons. Loads a library under the GPL.

    Parameters
    ----------
    mesh
        A mesh without openings; several bodies will do.
    quality_speed_tradeoff : float, 0.001 to 100, default: 0.1
        Smaller is faster and coarser.
    medially_centered_speed_tradeoff : float, 0 to 100, default: 0.2
        Larger is closer to the medial axis, less smooth and slower.
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    Skeleton
        As that of marrow.skeleton.

    Raises
    ------
    Error
        If the mesh cannot be used, or Marrow was built without CGAL.

    Examples
    --------
    >>> import marrow
    >>> if hasattr(marrow.vtk, "vtkMarrowMeanCurvatureSkeleton"):  # built with CGAL
    ...     skeleton = marrow.mean_curvature_skeleton(marrow.creature("capsule"))
    ...     assert len(skeleton.terminals) >= 2
    """
    try:
        algorithm = vtk.vtkMarrowMeanCurvatureSkeleton()
    except AttributeError:
        raise Error("mean_curvature_skeleton: Marrow was built without CGAL.") from None
    set_parameters(
        algorithm, mean_curvature_skeleton, MeanCurvatureSkeletonParameters, parameters)
    return watched_skeleton(algorithm, mesh, "mean_curvature_skeleton", progress, progress_bar)


def watched_skeleton(
    algorithm: vtkAlgorithm,
    mesh: MeshLike,
    subject: str,
    progress: Optional[ProgressCallback],
    progress_bar: bool,
) -> Skeleton:
    with Watch(subject, progress, progress_bar) as watch:
        return run_skeleton(algorithm, mesh, subject, watch)


def run_skeleton(
    algorithm: vtkAlgorithm,
    mesh: MeshLike,
    subject: str,
    watch: Watch,
    begin: float = 0.0,
    end: float = 1.0,
) -> Skeleton:
    algorithm.SetInputData(polydata_of(mesh))
    run(algorithm, subject, watch, begin, end)
    return Skeleton(polydata_output(algorithm, 0), Measures(polydata_output(algorithm, 1)))


def skeleton_of(
    mesh: Union[MeshLike, Skeleton], subject: str, watch: Watch, begin: float, end: float
) -> Skeleton:
    """The skeleton itself, or that of the mesh by the defaults."""
    if isinstance(mesh, Skeleton):
        return mesh
    return run_skeleton(vtk.vtkMSPSkeleton(), mesh, subject, watch, begin, end)
