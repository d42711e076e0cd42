# SPDX-License-Identifier: BSD-3-Clause
"""Marrow's VTK classes as they are, to build pipelines of them.

>>> from marrow.vtk import vtkMSPSkeleton
>>> vtkMSPSkeleton().GetClassName()
'vtkMSPSkeleton'

A module is loaded when a class of it is first asked for: nobody needs OpenGL for a skeleton, and
MarrowSkeletonCGAL, which is under the GPL, is loaded by those only who use it.
"""
from importlib import import_module as _import_module
from typing import Any as _Any

# Most used first, CGAL's last: a class is looked for in this order.
_MODULES = (
    "MarrowSkeleton",
    "MarrowTransfer",
    "MarrowCollection",
    "MarrowCorrespondence",
    "MarrowMeasures",
    "MarrowSurface",
    "MarrowEvaluation",
    "MarrowIO",
    "MarrowCreatures",
    "MarrowRendering",
    "MarrowSkeletonCGAL",
)


def __getattr__(name: str) -> _Any:
    if name.startswith("vtk"):
        for module in _MODULES:
            try:
                loaded = _import_module(f"{__name__}.{module}")
            except ModuleNotFoundError:  # not built, as MarrowSkeletonCGAL without CGAL
                continue
            if hasattr(loaded, name):
                return getattr(loaded, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
