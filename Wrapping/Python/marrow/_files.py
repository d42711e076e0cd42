# SPDX-License-Identifier: BSD-3-Clause
"""marrow.read and marrow.write: the files that the command knows."""
from __future__ import annotations

import os
from typing import Any, Optional, Union

from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._mesh import Mesh, MeshLike, Segments, polydata_of, set_segments
from ._messages import Error, collected_messages
from ._run import polydata_output, run
from ._skeleton import Skeleton
from .vtk import (
    vtkMarrowMeshReader,
    vtkMarrowMeshWriter,
    vtkMarrowSegmentReader,
    vtkMarrowSegmentSelector,
    vtkMarrowSegmentWriter,
)

Path = Union[str, "os.PathLike[str]"]


def read(path: Path, segments: Optional[Path] = None) -> Mesh:
    """Reads a mesh, a face of the file each.

    Parameters
    ----------
    path
        A file .off, .ply, .obj, .stl, .vtp, .vtu or .vtk; but for .vtp and .vtu also compressed, as
        .off.gz. Corners that .stl repeats are merged.
    segments
        A file .seg, one integer per face; or what of the file the segments are: the name of an array
        of cells or points or of a face property, or "groups", "objects", "materials" or "colors".

    Returns
    -------
    Mesh
        The faces in the order of the file.

    Raises
    ------
    Error
        If the content of a file cannot be used; where, and why.
    OSError
        If a file cannot be opened.

    Examples
    --------
    >>> import marrow
    >>> marrow.read("no-mesh.docx")
    Traceback (most recent call last):
    marrow._messages.Error: no-mesh.docx: the name must end in one of .off, .ply, .obj, .stl, .vtp, .vtu, .vtk...
    """
    name = os.fspath(path)
    reader = vtkMarrowMeshReader()
    _require_kind(name, vtkMarrowMeshReader)
    _require_readable(name)
    reader.SetFileName(name)
    run(reader, name)
    polydata = polydata_output(reader)
    if segments is not None:
        polydata = _with_segments(polydata, name, os.fspath(segments))
    return Mesh(polydata)


def write(
    mesh: Union[MeshLike, Skeleton], path: Path, *, segments: Segments = None
) -> None:
    """Writes a mesh, a skeleton, or the segments of a mesh.

    Parameters
    ----------
    mesh
        What marrow's functions return, or a mesh.
    path
        A file .vtp or .vtk, with all arrays; .ply, .obj or .off, of a mesh with its segments as face
        property, groups or face colours; or .seg for one integer per face.
    segments : (m,) int, or the name of a cell array
        The segment of each face. Default: the mesh's own, the array "SegmentId".

    Raises
    ------
    Error
        If the mesh or its segments cannot be written in that format.
    OSError
        If the file cannot be written.

    Examples
    --------
    >>> import marrow, os, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = os.path.join(folder, "creature.seg")
    ...     marrow.write(marrow.creature("snake"), path)
    ...     sorted(set(open(path).read().split()))
    ['0', '1', '2']
    """
    name = os.fspath(path)
    _require_kind(name, vtkMarrowMeshWriter, vtkMarrowSegmentWriter)
    polydata = polydata_of(mesh.polydata if isinstance(mesh, Skeleton) else mesh)
    array = set_segments(polydata, segments)
    writer = (vtkMarrowSegmentWriter if _is_of(vtkMarrowSegmentWriter, name)
              else vtkMarrowMeshWriter)()
    writer.SetInputArrayToProcess(0, 0, 0, vtkPolyData.FIELD_ASSOCIATION_CELLS, array)
    writer.SetInputData(polydata)
    writer.SetFileName(name)
    _require_writable(name)
    with collected_messages(name):
        writer.Write()


def _is_of(kind: Any, name: str) -> bool:
    return name.lower().endswith(tuple(kind.GetFileExtensions().split()))


def _require_kind(name: str, *kinds: Any) -> None:
    if not any(_is_of(kind, name) for kind in kinds):
        endings = " ".join(kind.GetFileExtensions() for kind in kinds).split()
        raise Error(f"{name}: the name must end in one of {', '.join(endings)}.")


def _require_readable(name: str) -> None:
    with open(name, "rb"):
        pass  # Raises FileNotFoundError and the like.


def _require_writable(name: str) -> None:
    is_new = not os.path.lexists(name)
    with open(name, "ab"):
        pass  # Python's exception says better than VTK why a file cannot be written.
    if is_new:
        os.remove(name)


def _with_segments(polydata: vtkPolyData, name: str, segments: str) -> vtkPolyData:
    if _is_of(vtkMarrowSegmentReader, segments):
        _require_readable(segments)
        algorithm, name = vtkMarrowSegmentReader(), segments
        algorithm.SetFileName(segments)
    else:
        algorithm = vtkMarrowSegmentSelector()
        algorithm.SetLabels(segments)
    algorithm.SetInputData(polydata)
    run(algorithm, name)
    return polydata_output(algorithm)
