# SPDX-License-Identifier: BSD-3-Clause
"""marrow.evaluate: vtkMarrowSegmentationMetrics."""
from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from ._mesh import Mesh, MeshLike, Segments, polydata_of, set_segments
from ._parameters import snake_case
from ._progress import ProgressCallback, Watch
from ._run import run
from .vtk import vtkMarrowSegmentationMetrics


@dataclass(frozen=True)
class Evaluation:
    """How well segments agree with a reference: what marrow.evaluate returns.

    All but the label accuracy are 0 where both agree, whatever the numbers of the segments are.
    """

    cut_discrepancy: float
    """Mean distance between the boundaries of the two, over the mesh's average radius."""
    hamming_distance: float
    """Mean of the missing rate and the false alarm rate."""
    missing_rate: float
    """Share of the area that reference segments have outside of those that cover them best."""
    false_alarm_rate: float
    """The same the other way round."""
    rand_error: float
    """Share of the pairs of faces that are together in one and apart in the other."""
    global_consistency_error: float
    """0 if one refines the other, over the whole mesh."""
    local_consistency_error: float
    """The same face by face."""
    label_accuracy: float
    """Share of the area with equal numbers, where these mean the same in both; 1 is best."""
    boundary_distance: float
    """Mean distance between the boundaries, over the diagonal of the bounding box."""


def evaluate(
    mesh: MeshLike,
    reference: Union[vtkPolyData, Mesh, ArrayLike],
    *,
    segments: Segments = None,
    progress: Optional[ProgressCallback] = None,
    progress_bar: bool = False,
) -> Evaluation:
    """How well the segments of a mesh agree with a reference.

    Parameters
    ----------
    mesh
        The mesh with its segments.
    reference
        The same mesh with other segments in the cell array "SegmentId", or these segments alone,
        (m,) int.
    segments : (m,) int, or the name of a cell array
        The segments to be judged. Default: the mesh's own, the array "SegmentId".
    progress, progress_bar
        A function that is called with the fraction done; a bar on stderr.

    Returns
    -------
    Evaluation
        Numbers only; see also the class vtkMarrowSegmentationMetrics.

    Raises
    ------
    Error
        If the mesh or the segments cannot be used.

    Examples
    --------
    >>> import marrow
    >>> creature = marrow.creature("biped")
    >>> marrow.evaluate(creature, creature.segments).label_accuracy
    1.0
    """
    algorithm = vtkMarrowSegmentationMetrics()
    judged = polydata_of(mesh)
    judge: Segments = None
    if isinstance(reference, (vtkPolyData, Mesh)):
        other = polydata_of(reference)
    else:
        other, judge = polydata_of(judged), np.asarray(reference)
    for port, (polydata, values) in enumerate([(judged, segments), (other, judge)]):
        name = set_segments(polydata, values)
        algorithm.SetInputData(port, polydata)
        algorithm.SetInputArrayToProcess(
            port, port, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, name)
    with Watch("evaluate", progress, progress_bar) as watch:
        run(algorithm, "evaluate", watch)
    getters = {snake_case(name[3:]): name for name in dir(algorithm) if name.startswith("Get")}
    return Evaluation(
        **{field.name: getattr(algorithm, getters[field.name])() for field in fields(Evaluation)})
