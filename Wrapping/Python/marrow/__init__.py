# SPDX-License-Identifier: BSD-3-Clause
"""Marrow: carries the segments of one triangle mesh to others of its kind, by their skeletons.

    import marrow
    camel = marrow.read("camel.off", segments="camel.seg")
    cow = marrow.transfer(camel, marrow.read("cow.off"))
    cow.segments                              # (m,) int, one per face; cow.polydata is the mesh
    marrow.render(camel, cow, path="animals.png")

A mesh is a vtkPolyData (of a subclass too, as pyvista's), a marrow.Mesh, or a pair (points, faces) of
arrays of the shapes (n, 3), float, and (m, 3), int. It is never changed. What comes out has the
vtkPolyData with all arrays, and numpy's read-only views on them.

Functions: measure, skeleton, mean_curvature_skeleton, correspond, transfer, cut, collection, fuse,
evaluate, render, read, write, creature. Their keyword arguments are the parameters of the VTK classes, in
marrow.vtk; what is not given, or None, has the default of the class. Lengths among them are ratios, so
units do not matter. Errors are marrow.Error, warnings marrow.MarrowWarning; Ctrl-C stops a computation.
"""
from ._collection import Collected, Fusion, collection, fuse
from ._correspondence import Correspondence, Match, correspond
from ._creature import creature
from ._cut import Cut, cut
from ._evaluation import Evaluation, evaluate
from ._files import read, write
from ._measures import Measures, measure
from ._mesh import Mesh, MeshLike
from ._messages import Error, MarrowWarning
from ._picture import render
from ._skeleton import NodeType, Skeleton, mean_curvature_skeleton, skeleton
from ._transfer import Boundaries, Transfer, transfer
from ._version import __version__

__all__ = [
    "Boundaries",
    "Collected",
    "Correspondence",
    "Cut",
    "Error",
    "Evaluation",
    "Fusion",
    "MarrowWarning",
    "Match",
    "Measures",
    "Mesh",
    "MeshLike",
    "NodeType",
    "Skeleton",
    "Transfer",
    "__version__",
    "collection",
    "correspond",
    "creature",
    "cut",
    "evaluate",
    "fuse",
    "mean_curvature_skeleton",
    "measure",
    "read",
    "render",
    "skeleton",
    "transfer",
    "write",
]
