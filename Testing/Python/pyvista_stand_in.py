# SPDX-License-Identifier: BSD-3-Clause
"""What marrow uses of pyvista 0.48, where pyvista is not installed (Debian 12 does not have it): its meshes,
and how it finds accessors. Imported under the name pyvista."""
import importlib
import importlib.metadata
import importlib.util
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

ACCESSORS = {}


class PolyData(vtkPolyData):
    def __init__(self, other=None):
        if other is not None:
            self.ShallowCopy(other)

    @property
    def point_data(self):
        return _arrays(self.GetPointData())

    @property
    def cell_data(self):
        return _arrays(self.GetCellData())

    def __getattr__(self, name):
        # Entry points are loaded when a name is asked for that the mesh does not have.
        if name not in ACCESSORS:
            for entry in importlib.metadata.entry_points(group="pyvista.accessors", name=name):
                importlib.import_module(entry.value)
        if name not in ACCESSORS:
            raise AttributeError(name)
        return ACCESSORS[name](self)


def _arrays(data):
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())
            if data.GetArray(i) is not None}


def wrap(polydata):
    return PolyData(polydata)


def register_dataset_accessor(name, target):
    assert target is PolyData

    def register(accessor):
        ACCESSORS[name] = accessor
        return accessor
    return register


def provide():
    """Makes `import pyvista` work; the real one is taken where it is installed."""
    if importlib.util.find_spec("pyvista") is None:
        sys.modules["pyvista"] = sys.modules[__name__]
