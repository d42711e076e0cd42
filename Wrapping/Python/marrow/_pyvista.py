# SPDX-License-Identifier: BSD-3-Clause
"""mesh.marrow of pyvista's meshes. pyvista 0.48 and later imports this module by itself, by the entry point
pyvista.accessors, when mesh.marrow is first asked for; for earlier ones it is of no use."""
from __future__ import annotations

from typing import Any

import pyvista

from ._measures import measure
from ._mesh import Segments
from ._skeleton import skeleton
from ._transfer import transfer


@pyvista.register_dataset_accessor("marrow", pyvista.PolyData)
class MarrowAccessor:
    """The functions of marrow as methods of a pyvista.PolyData, with meshes of pyvista's as results.

    The keyword arguments are those of the functions.
    """

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh

    def measure(self, **parameters: Any) -> Any:
        """What the mesh is like at each vertex: marrow.measure.

        Parameters
        ----------
        **parameters
            As of marrow.measure.

        Returns
        -------
        pyvista.PolyData
            The mesh with the point arrays "MSP", "AGD" and so on.

        Raises
        ------
        marrow.Error
            If the mesh cannot be used.

        Examples
        --------
        >>> import marrow, pyvista
        >>> mesh = pyvista.wrap(marrow.creature("capsule").polydata)
        >>> "MSP" in mesh.marrow.measure().point_data
        True
        """
        return pyvista.wrap(measure(self._mesh, **parameters).polydata)

    def skeleton(self, **parameters: Any) -> Any:
        """The curve skeleton of the mesh: marrow.skeleton.

        Parameters
        ----------
        **parameters
            As of marrow.skeleton.

        Returns
        -------
        pyvista.PolyData
            Points are nodes, every branch is a polyline.

        Raises
        ------
        marrow.Error
            If the mesh cannot be used.

        Examples
        --------
        >>> import marrow, pyvista
        >>> mesh = pyvista.wrap(marrow.creature("biped").polydata)
        >>> int((mesh.marrow.skeleton().point_data["NodeType"] == 1).sum())  # head, hands, feet
        5
        """
        return pyvista.wrap(skeleton(self._mesh, **parameters).polydata)

    def transfer_to(self, other: Any, *, segments: Segments = None, **parameters: Any) -> Any:
        """Carries the segments of this mesh to another: marrow.transfer.

        Parameters
        ----------
        other : pyvista.PolyData, or another mesh that marrow.transfer takes
            The target.
        segments : (m,) int, or the name of a cell array
            The segment of each face of this mesh. Default: its array "SegmentId".
        **parameters
            As of marrow.transfer.

        Returns
        -------
        pyvista.PolyData
            The target with the cell arrays "SegmentId" and "SegmentConfidence".

        Raises
        ------
        marrow.Error
            If a mesh or the segments cannot be used.

        Examples
        --------
        >>> import marrow, pyvista
        >>> mesh, other = (pyvista.wrap(marrow.creature("biped", seed=i).polydata) for i in (1, 2))
        >>> len(set(mesh.marrow.transfer_to(other).cell_data["SegmentId"]))
        7
        """
        return pyvista.wrap(transfer(self._mesh, other, segments=segments, **parameters).polydata)
