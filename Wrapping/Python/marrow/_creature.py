# SPDX-License-Identifier: BSD-3-Clause
"""marrow.creature: vtkCreatureSource."""
from __future__ import annotations

from typing import Literal, Optional, TypedDict, Unpack

from ._mesh import Mesh
from ._parameters import set_parameter, set_parameters
from ._run import polydata_output, run
from .vtk import vtkCreatureSource


Shape = Literal["biped", "quadruped", "octopus", "chair", "snake", "torus", "capsule"]


class CreatureParameters(TypedDict, total=False):
    pose: Optional[float]
    proportion: Optional[float]
    resolution: Optional[int]
    noise: Optional[float]
    seed: Optional[int]


def creature(
    shape: Optional[Shape] = None, **parameters: Unpack[CreatureParameters]
) -> Mesh:
    """A labelled creature, made by a procedure, to try things with.

    Parameters
    ----------
    shape : "biped", "quadruped", "octopus", "chair", "snake", "torus" or "capsule", default: "quadruped"
        What to make.
    pose, proportion : float, 0 to 1, default: 0
        How far, at random, joints are bent, and lengths and thicknesses vary.
    resolution : int, 2000 to 2000000, default: 10000
        Number of triangles, kept within 10 %.
    noise : float, 0 to 0.02, default: 0
        Roughness of the surface, over the diagonal of the bounding box.
    seed : int, default: 1
        Selects the individual.

    Returns
    -------
    Mesh
        A mesh with its segments; see also the class vtkCreatureSource.

    Raises
    ------
    Error
        If a parameter is out of its range.

    Examples
    --------
    >>> import marrow
    >>> sorted(set(marrow.creature("snake").segments.tolist()))  # body, head, tail
    [0, 1, 2]
    """
    source = vtkCreatureSource()
    set_parameter(source, "shape", shape)
    set_parameters(source, creature, CreatureParameters, parameters)
    run(source, "creature")
    return Mesh(polydata_output(source))
