# SPDX-License-Identifier: BSD-3-Clause
"""Runs a filter to its end, or to an exception."""
from __future__ import annotations

from typing import Optional

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from ._messages import collected_messages
from ._progress import Watch


def run(
    algorithm: vtkAlgorithm,
    subject: str,
    watch: Optional[Watch] = None,
    begin: float = 0.0,
    end: float = 1.0,
) -> None:
    """Updates the algorithm; its errors are raised as Error, headed by `subject`."""
    if watch is not None:
        watch.follow(algorithm, begin, end)
    with collected_messages(subject):
        algorithm.Update()
        if watch is not None:
            # Before the messages: an abort may make a filter complain of what is missing then.
            watch.raise_if_stopped()


def polydata_output(algorithm: vtkAlgorithm, port: int = 0) -> vtkPolyData:
    """An output of its own, that lives on without the algorithm."""
    copy = vtkPolyData()
    copy.ShallowCopy(algorithm.GetOutputDataObject(port))
    return copy
