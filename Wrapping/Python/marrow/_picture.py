# SPDX-License-Identifier: BSD-3-Clause
"""marrow.render: vtkMarrowSideBySideScene."""
from __future__ import annotations

import os
from typing import Literal, Optional, Sequence, TypedDict, Union, Unpack

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

from . import vtk
from ._arrays import Array, view
from ._files import Path
from ._mesh import MeshLike, polydata_of
from ._messages import Error, collected_messages
from ._parameters import set_parameters
from ._skeleton import Skeleton

_OPACITY_ROUND_SKELETONS = 0.3


class SceneParameters(TypedDict, total=False):
    view_up: Optional[Sequence[float]]
    view_direction: Optional[Sequence[float]]
    azimuth: Optional[float]
    elevation: Optional[float]
    align: Optional[bool]
    surface_opacity: Optional[float]
    show_links: Optional[bool]
    share_range: Optional[bool]
    label_array_name: Optional[str]
    tile_width: Optional[int]
    tile_height: Optional[int]
    columns: Optional[int]


def render(
    *meshes: Union[MeshLike, Skeleton],
    path: Optional[Path] = None,
    captions: Optional[Sequence[str]] = None,
    surface_array: Union[str, Sequence[Optional[str]], None] = None,
    color_skeleton_by: Optional[Literal["node_type", "correspondence", "branch", "label"]] = None,
    **parameters: Unpack[SceneParameters],
) -> Array:
    """Draws meshes side by side, seen from the same side; equal segments have equal colours.

    Needs an X display.

    Parameters
    ----------
    meshes
        Meshes, coloured by their segments; a skeleton is drawn inside of its transparent mesh.
    path
        A file .png to be written too.
    captions : one str per mesh
    surface_array : str, or one str or None per mesh
        Name of an array to colour the surfaces by, with a scalar bar: "MSP", "SegmentConfidence".
    color_skeleton_by : "node_type", "correspondence", "branch" or "label"
        What the skeletons' colours tell.
    show_links : bool, default: False
        Lines between the matched nodes of the first skeleton and the others.
    share_range : bool, default: False
        One range of colours for all, so that equal colours are equal values.
    view_up : 3 floats, default: (0, 1, 0)
        What is up in the first mesh.
    view_direction : 3 floats, default: (0, 0, 0)
        From where the first mesh is seen; (0, 0, 0): from its broad side.
    azimuth : float, degrees, default: 25
        Turn of the eye to the side.
    elevation : float, degrees, default: 12
        Turn of the eye upwards.
    align : bool, default: True
        Turn the other meshes to stand like the first.
    surface_opacity : float, 0 to 1, default: 1
        Of all surfaces; else only those around a skeleton are transparent.
    label_array_name : str, default: "SegmentId"
        Name of the cell array with the segments.
    tile_width, tile_height : int, 16 to 4096, pixels, default: 400
    columns : int, default: 0
        Meshes in a row; 0: all.

    Returns
    -------
    (height, width, 3) uint8
        The picture, the top row first.

    Raises
    ------
    Error
        If there is no display, a mesh cannot be drawn, or the path does not end in .png.

    Examples
    --------
    >>> import marrow
    >>> marrow.render(marrow.creature("snake"), tile_width=320, tile_height=200).shape
    (200, 320, 3)
    """
    if not vtk.vtkMarrowSideBySideScene.HasDisplay():
        # VTK would end the process.
        raise Error(
            "render: there is no X display to draw with: set DISPLAY to one that is there, or put 'xvfb-run -a -s "
            "\"-screen 0 1280x1024x24 -noreset\"' before the command."
        )
    titles = _per_mesh("captions", captions, meshes)
    arrays = _per_mesh("surface_array", surface_array, meshes)
    scene = vtk.vtkMarrowSideBySideScene()
    set_parameters(scene, render, SceneParameters, parameters)
    if color_skeleton_by is not None:
        scene.SetColorSkeletonBy(_color_by(color_skeleton_by))
    image = vtkImageData()
    with collected_messages("render"):
        for mesh, title, array in zip(meshes, titles, arrays):
            skeleton = mesh.polydata if isinstance(mesh, Skeleton) else None
            surface = polydata_of(mesh.mesh if isinstance(mesh, Skeleton) else mesh)
            tile = scene.AddMesh(surface, skeleton, title)
            if array is not None:
                scene.SetSurfaceArray(tile, array)
            if skeleton is not None and parameters.get("surface_opacity") is None:
                scene.SetTileOpacity(tile, _OPACITY_ROUND_SKELETONS)
        scene.Render(image)
    if path is not None:
        _write_png(image, os.fspath(path))
    width, height, _ = image.GetDimensions()
    pixels = view(image.GetPointData().GetScalars()).reshape(height, width, 3)
    return np.flipud(pixels).copy()


def _per_mesh(
    keyword: str, given: Union[str, Sequence[Optional[str]], None], meshes: Sequence[object]
) -> Sequence[Optional[str]]:
    if given is None or isinstance(given, str):
        return [given] * len(meshes)
    if len(given) != len(meshes):
        raise Error(f"{keyword}: there are {len(given)} for {len(meshes)} meshes.")
    return given


def _color_by(name: str) -> int:
    choices = [key.lower() for key in vars(vtk.vtkMarrowSkeletonGlyphs) if key.isupper()]
    if name not in choices:
        raise Error(
            f"color_skeleton_by must be one of {', '.join(map(repr, choices))}, not {name!r}.")
    return int(getattr(vtk.vtkMarrowSkeletonGlyphs, name.upper()))


def _write_png(image: vtkImageData, name: str) -> None:
    if not name.lower().endswith(".png"):
        raise Error(f"{name}: the name must end in .png.")
    with open(name, "ab"):
        pass  # Python's exception says better than VTK why a file cannot be written.
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(name)
    with collected_messages(name):
        writer.Write()
