# SPDX-License-Identifier: BSD-3-Clause
"""What VTK says becomes exceptions and warnings of Python's; nothing is printed."""
from __future__ import annotations

import sys
import threading
import warnings
from contextlib import contextmanager
from typing import Iterator

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow


class Error(ValueError):
    """A mesh, a file or a parameter that cannot be used: what is wrong, where, and the remedy."""


class MarrowWarning(UserWarning):
    """A result that is not what was to be expected; it says why."""


# There is one output window for all threads. Reentrant: a callback may call our functions.
_window_in_use = threading.RLock()


@contextmanager
def collected_messages(subject: str) -> Iterator[None]:
    """Raises Error, headed by `subject`, if VTK tells of an error within; passes its warnings on.

    All of VTK's messages go to its output window, also those of filters that run inside others, so
    that is what is exchanged for the time. Its logger would print every one of them besides.
    """
    errors: list[str] = []
    notes: list[str] = []

    def listen(_window: object, event: str, text: str) -> None:
        (errors if event == "ErrorEvent" else notes).append(_sentence(text))

    listen.CallDataType = "string0"  # type: ignore[attr-defined]
    window = vtkStringOutputWindow()
    window.AddObserver("ErrorEvent", listen)
    window.AddObserver("WarningEvent", listen)
    with _window_in_use:
        users_window = vtkOutputWindow.GetInstance()
        users_verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        vtkOutputWindow.SetInstance(window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        try:
            yield
        finally:
            vtkLogger.SetStderrVerbosity(users_verbosity)
            vtkOutputWindow.SetInstance(users_window)
            window.RemoveAllObservers()
    for note in dict.fromkeys(notes):
        warnings.warn(f"{subject}: {note}", MarrowWarning, stacklevel=_users_level())
    if errors:
        # The pipeline's own word, that a filter failed, says nothing that the filter did not say.
        told = [error for error in errors if "returned failure for request" not in error]
        reasons = list(dict.fromkeys(told)) or ["it cannot be processed."]
        raise Error(f"{subject}: {' '.join(reasons)}")


def _sentence(text: str) -> str:
    """SENTENCE of VTK's "ERROR: In FILE, line N\\nvtkClass (0x...): SENTENCE\\n\\n"."""
    text = text[text.find("\n") + 1:]
    _, found, after = text.partition("): ")
    sentence = " ".join((after if found else text).split())
    return sentence if sentence.endswith(".") else sentence + "."


def _users_level() -> int:
    """The stack level of the line outside of this package that a warning is about."""
    level, frame = 1, sys._getframe(1)
    own = (__name__.partition(".")[0], "contextlib")
    while frame.f_back and frame.f_globals.get("__name__", "").partition(".")[0] in own:
        level, frame = level + 1, frame.f_back
    return level
