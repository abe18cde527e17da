"""Blame: what is said of a part that fails, with its name and the package that it came from."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from acoexp import registry
from acoexp.errors import StrategyError
from acoexp.settings import Settings


def told(settings: Settings, group: str) -> str:
    """Return the words for a part, such as ``diffusion 'shy' of package acoexp-shy 1.0``."""
    package = _package(settings, group)
    return f"{group} {settings.names[group]!r}" + (f" of package {package}" if package else "")


def check_state(settings: Settings, group: str, state: Any) -> None:
    """Refuse what no kernel can take as a part's own state.

    Raises:
        StrategyError: if it is no tuple of numbers and arrays.
    """
    expected = f"{told(settings, group)}: expected prepare to return a tuple of numbers and arrays"
    if not isinstance(state, tuple):
        raise StrategyError(f"{expected}; got {type(state).__name__}")
    for place, value in enumerate(state):
        number = isinstance(value, np.number | np.bool_ | int | float | complex)
        array = isinstance(value, np.ndarray) and value.dtype.kind in "biufc"
        if not (number or array):
            raise StrategyError(f"{expected}; got {type(value).__name__} at place {place}")


def not_compiled(settings: Settings, kernels: dict[str, Any], problem: Exception) -> StrategyError:
    """Return the error for a colony that cannot be compiled: what the compiler says, and at which kernels."""
    text = str(problem)
    functions = {group: repr(getattr(kernel, "py_func", kernel)) for group, kernel in kernels.items() if kernel}
    faulty = [group for group, function in functions.items() if function in text]
    at_fault = f"; at fault: {', '.join(told(settings, group) for group in faulty)}" if faulty else ""
    return StrategyError(f"{_colony(settings)} cannot be compiled: {_gist(text, type(problem))}{at_fault}")


def raised(settings: Settings, seed: int, problem: Exception) -> StrategyError:
    """Return the error for a kernel that raised, which kernels may not do."""
    what = f"{type(problem).__name__}: {problem}"
    return StrategyError(f"a kernel of {_colony(settings)} raised, seed {seed}: {what}")


def _colony(settings: Settings) -> str:
    parts = []
    for group, name in settings.names.items():
        package = _package(settings, group)
        foreign = package is not None and not package.startswith("acoexp ")
        parts.append(f"{group}={name}" + (f" of {package}" if foreign else ""))
    return f"the colony ({', '.join(parts)})"


def _package(settings: Settings, group: str) -> str | None:
    return registry.package_of(group, type(settings.parts[group]))


def _gist(text: str, kind: type) -> str:
    """Return what a compiler's error says, and where, without the way it got there."""
    lines: Sequence[str] = [line.strip() for line in text.splitlines() if line.strip()]
    says = next((line for line in lines if not line.startswith("Failed in nopython")), kind.__name__)
    where = next((line for line in lines if line.startswith("File ")), "")
    return f"{says} {where}".strip()
