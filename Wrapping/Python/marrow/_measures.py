# SPDX-License-Identifier: BSD-3-Clause
"""marrow.measure: vtkMSPField."""
from __future__ import annotations

from typing import Literal, Optional, TypedDict, Unpack

from ._arrays import Array, named
from ._mesh import Mesh, MeshLike, polydata_of
from ._parameters import set_parameters
from ._progress import ProgressCallback, Watch
from ._run import polydata_output, run
from .vtk import vtkMSPField


class MeasureParameters(TypedDict, total=False):
    number_of_slices: Optional[int]
    maximum_faces: Optional[int]
    agd_method: Optional[Literal["sampled", "all_pairs"]]


class Measures(Mesh):
    """A mesh and its measures: what marrow.measure returns. n is the number of vertices."""

    @property
    def agd(self) -> Array:
        """(n,) float: average geodesic distance, 0 (middle) to 1 (extremities) per component."""
        return named(self.polydata.GetPointData(), "AGD")

    @property
    def msp(self) -> Array:
        """(n,) float: minimum slice perimeter, in the mesh's units: how thick the part is here."""
        return named(self.polydata.GetPointData(), "MSP")

    @property
    def msp_center(self) -> Array:
        """(n, 3) float: the centroid of that slice, in the middle of the part."""
        return named(self.polydata.GetPointData(), "MSPCenter")

    @property
    def msp_normal(self) -> Array:
        """(n, 3) float: unit normal of that slice's plane; the sign means nothing."""
        return named(self.polydata.GetPointData(), "MSPNormal")

    @property
    def msp_gradient(self) -> Array:
        """(n, 3) float: gradient of msp on the surface, no unit: long where the thickness changes."""
        return named(self.polydata.GetPointData(), "MSPGradient")

    @property
    def msp_valid(self) -> Array:
        """(n,) bool: False where no slice closes, as next to a border, and its value was completed."""
        return named(self.polydata.GetPointData(), "MSPValid").astype(bool)

    @property
    def dihedral_angle(self) -> Array:
        """(n,) float: mean angle between the triangles that meet here, radians, convex positive."""
        return named(self.polydata.GetPointData(), "DihedralAngle")


def measure(
    mesh: MeshLike,
    *,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
    **parameters: Unpack[MeasureParameters],
) -> Measures:
    """What the mesh is like at each vertex: how thick, how far out, how bent.

    Parameters
    ----------
    mesh
        Any mesh: one that is no clean manifold is measured on its working surface.
    number_of_slices : int, 2 to 180, default: 12
        Planes tried at each vertex; more find a smaller perimeter and cost in proportion.
    maximum_faces : int, 0 to 2147483647, default: 0
        A mesh of more faces is measured on a working surface of so many; 0: at every vertex.
    agd_method : "sampled" or "all_pairs", default: "sampled"
        Distances from 64 samples of each component, or from all vertices (slow, exact).
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    Measures
        The mesh with its measures, one value per vertex; see also the class vtkMSPField.

    Raises
    ------
    Error
        If the mesh cannot be used.

    Examples
    --------
    >>> import marrow
    >>> measures = marrow.measure(marrow.creature("capsule"))
    >>> bool(measures.agd.min() == 0.0 and measures.agd.max() == 1.0)
    True
    >>> measures.msp_center.shape == measures.points.shape
    True
    """
    field = vtkMSPField()
    set_parameters(field, measure, MeasureParameters, parameters)
    field.SetInputData(polydata_of(mesh))
    with Watch("measure", progress, progress_bar) as watch:
        run(field, "measure", watch)
    return Measures(polydata_output(field))
