# SPDX-License-Identifier: BSD-3-Clause
"""Keyword arguments and the parameters of VTK's classes. Defaults are those of C++, and only there."""
from __future__ import annotations

import inspect
import re
from typing import Any, Callable, Dict, Mapping, Optional

from vtkmodules.vtkCommonCore import vtkObject

from ._messages import Error


def snake_case(name: str) -> str:
    """AGDMethod -> agd_method."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def set_parameters(
    instance: vtkObject, function: Callable[..., Any], allowed: type, given: Mapping[str, Any]
) -> None:
    """Sets what is given and not None; `allowed` is the TypedDict of the function's parameters."""
    names = list(allowed.__annotations__)
    for keyword, value in given.items():
        if keyword not in names:
            known = [
                name
                for name, parameter in inspect.signature(function).parameters.items()
                if parameter.kind is inspect.Parameter.KEYWORD_ONLY
            ]
            raise TypeError(
                f"{function.__name__}() got an unexpected keyword argument {keyword!r}; "
                f"it takes {', '.join(known + names)}"
            )
        set_parameter(instance, keyword, value)


def set_parameter(instance: vtkObject, keyword: str, value: Any) -> None:
    """None leaves the default."""
    if value is None:
        return
    wanted = keyword.rstrip("_")  # lambda_
    setter = next(
        name for name in dir(instance) if name[:3] == "Set" and snake_case(name[3:]) == wanted
    )
    choices = choices_of(instance, setter)
    if choices and isinstance(value, str):
        if value not in choices:
            raise Error(f"{keyword} must be one of {', '.join(map(repr, choices))}, not {value!r}.")
        choices[value]()
        return
    try:
        getattr(instance, setter)(value)
    except TypeError as error:
        raise TypeError(f"{keyword}={value!r}: {error}") from None
    least = _bound(instance, setter, "MinValue")
    most = _bound(instance, setter, "MaxValue")
    # VTK's setters clamp in silence.
    if least is not None and most is not None and not least <= value <= most:
        raise Error(f"{keyword} must be from {least} to {most}, not {value}.")


def choices_of(instance: vtkObject, setter: str) -> Dict[str, Callable[[], None]]:
    """What agd_method may be: "all_pairs" stands for SetAGDMethodToAllPairs."""
    prefix = setter + "To"
    return {
        snake_case(name[len(prefix):]): getattr(instance, name)
        for name in dir(instance)
        if name.startswith(prefix)
    }


def _bound(instance: vtkObject, setter: str, which: str) -> Optional[float]:
    getter = getattr(instance, "Get" + setter[3:] + which, None)
    return getter() if getter is not None else None
