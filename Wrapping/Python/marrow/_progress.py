# SPDX-License-Identifier: BSD-3-Clause
"""Progress of a filter, a bar to show it, and Ctrl-C to stop it."""
from __future__ import annotations

import signal
import sys
import threading
from types import FrameType
from typing import Any, Callable, Optional

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

ProgressCallback = Callable[[float], Any]
"""Is called with the fraction that is done, 0.0 to 1.0; an exception that it raises stops the work."""

_WIDTH_OF_BAR = 40


class Watch:
    """Follows the filters of one call of the user's: `with Watch(...) as watch: watch.follow(...)`.

    An exception must not leave a callback of VTK's (on KeyboardInterrupt VTK ends the process), so
    whatever stops the work is kept, the filter is told to abort, and it is raised at the end.
    """

    def __init__(self, title: str, progress: Optional[ProgressCallback], progress_bar: bool) -> None:
        self._title = title
        self._progress = progress
        self._bar = progress_bar
        self._done = -1.0
        self._drawn = ""
        self._stop: Optional[BaseException] = None
        self._users_handler: Any = None

    def __enter__(self) -> Watch:
        self._report(0.0)
        # Only the main thread may, and only what Python would call can be called later.
        if threading.current_thread() is threading.main_thread():
            if callable(signal.getsignal(signal.SIGINT)):
                self._users_handler = signal.signal(signal.SIGINT, self._interrupt)
        return self

    def __exit__(self, kind: Optional[type], *_: object) -> None:
        if self._users_handler is not None:
            signal.signal(signal.SIGINT, self._users_handler)
        if kind is None and self._stop is None:
            self._report(1.0)
        if self._bar:
            print(file=sys.stderr)
        if kind is None:
            self.raise_if_stopped()

    def follow(self, algorithm: vtkAlgorithm, begin: float, end: float) -> None:
        """Lets the algorithm's progress move this one from `begin` to `end`."""

        def listen(caller: vtkAlgorithm, _event: str) -> None:
            try:
                self._report(begin + (end - begin) * caller.GetProgress())
            except BaseException as exception:
                self._stop = self._stop or exception
            if self._stop is not None:
                caller.SetAbortExecute(1)

        algorithm.AddObserver("ProgressEvent", listen)

    def raise_if_stopped(self) -> None:
        if self._stop is not None:
            raise self._stop

    def _report(self, done: float) -> None:
        if self._stop is not None or done <= self._done:
            return
        self._done = done
        if self._bar:
            self._draw(done)
        if self._progress is not None:
            self._progress(done)

    def _draw(self, done: float) -> None:
        filled = round(done * _WIDTH_OF_BAR)
        bar = "#" * filled + "-" * (_WIDTH_OF_BAR - filled)
        line = f"\r{self._title} [{bar}] {100 * done:3.0f} %"
        if line != self._drawn:
            print(line, end="", file=sys.stderr, flush=True)
            self._drawn = line

    def _interrupt(self, signal_number: int, frame: Optional[FrameType]) -> None:
        try:
            self._users_handler(signal_number, frame)
        except BaseException as exception:
            self._stop = self._stop or exception
