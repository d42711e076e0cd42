# SPDX-License-Identifier: BSD-3-Clause
"""marrow.read and marrow.write: the files that the command knows."""
from __future__ import annotations

import os
from typing import Any, Callable, Dict, Optional, Union

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from ._mesh import Mesh, MeshLike, Segments, polydata_of, set_segments
from ._messages import Error, collected_messages
from ._run import polydata_output, run
from ._skeleton import Skeleton
from .vtk import vtkMarrowMeshReader, vtkMarrowSegmentReader, vtkMarrowSegmentWriter

Path = Union[str, "os.PathLike[str]"]

_READERS: Dict[str, Callable[[], Any]] = {
    ".off": vtkMarrowMeshReader,
    ".ply": vtkPLYReader,
    ".obj": vtkOBJReader,
    ".stl": vtkSTLReader,
    ".vtp": vtkXMLPolyDataReader,
    ".vtk": vtkPolyDataReader,
}
_WRITERS: Dict[str, Callable[[], Any]] = {
    ".vtp": vtkXMLPolyDataWriter,
    ".vtk": vtkPolyDataWriter,
    ".seg": vtkMarrowSegmentWriter,
}


def read(path: Path, segments: Optional[Path] = None) -> Mesh:
    """Reads a mesh, as triangles.

    Parameters
    ----------
    path
        A file .off, .ply, .obj, .stl, .vtp or .vtk. Corners that .obj and .stl repeat are merged.
    segments
        A file .seg: one integer per face.
    """
    name = os.fspath(path)
    reader = _of_extension(name, _READERS)()
    _require_readable(name)
    reader.SetFileName(name)
    run(reader, name)
    polydata = _triangles(polydata_output(reader), merge=name.lower().endswith((".obj", ".stl")))
    if polydata.GetNumberOfPolys() == 0:
        raise Error(f"{name}: the file holds no surface.")
    return Mesh(polydata) if segments is None else _with_segments(polydata, os.fspath(segments))


def write(
    mesh: Union[MeshLike, Skeleton], path: Path, *, segments: Segments = None
) -> None:
    """Writes a mesh, a skeleton, or the segments of a mesh.

    Parameters
    ----------
    mesh
        What marrow's functions return, or a mesh; with all of its arrays.
    path
        A file .vtp or .vtk, or .seg for one integer per face.
    segments : (m,) int, or the name of a cell array
        The segment of each face. Default: the mesh's own, the array "SegmentId".
    """
    name = os.fspath(path)
    writer = _of_extension(name, _WRITERS)()
    polydata = polydata_of(mesh.polydata if isinstance(mesh, Skeleton) else mesh)
    array = set_segments(polydata, segments)
    with open(name, "ab"):
        pass  # Python's exception says better than VTK why a file cannot be written.
    if writer.IsA("vtkMarrowSegmentWriter"):
        writer.SetInputArrayToProcess(0, 0, 0, vtkPolyData.FIELD_ASSOCIATION_CELLS, array)
    if writer.IsA("vtkPolyDataWriter"):
        writer.SetFileTypeToBinary()
    writer.SetInputData(polydata)
    writer.SetFileName(name)
    with collected_messages(name):
        writer.Write()


def _of_extension(name: str, kinds: Dict[str, Callable[[], Any]]) -> Callable[[], Any]:
    extension = os.path.splitext(name)[1].lower()
    if extension not in kinds:
        raise Error(f"{name}: the name must end in one of {', '.join(kinds)}.")
    return kinds[extension]


def _require_readable(name: str) -> None:
    with open(name, "rb"):
        pass  # Raises FileNotFoundError and the like.


def _triangles(polydata: vtkPolyData, merge: bool) -> vtkPolyData:
    if merge:
        # Keeps triangles that collapse: filters name them, and faces keep their numbers.
        clean = vtkCleanPolyData()
        clean.SetTolerance(0.0)
        clean.ConvertLinesToPointsOff()
        clean.ConvertPolysToLinesOff()
        clean.ConvertStripsToPolysOff()
        clean.SetInputData(polydata)
        run(clean, "read")
        polydata = polydata_output(clean)
    others = polydata.GetNumberOfCells() - polydata.GetNumberOfPolys()
    if others == 0 and polydata.GetPolys().IsHomogeneous() == 3:
        return polydata
    triangulate = vtkTriangleFilter()
    triangulate.PassVertsOff()
    triangulate.PassLinesOff()
    triangulate.SetInputData(polydata)
    run(triangulate, "read")
    return polydata_output(triangulate)


def _with_segments(polydata: vtkPolyData, name: str) -> Mesh:
    _require_readable(name)
    reader = vtkMarrowSegmentReader()
    reader.SetInputData(polydata)
    reader.SetFileName(name)
    run(reader, name)
    return Mesh(polydata_output(reader))
