"""Blame: what is said of a part that fails, with its name and the package that it came from."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from acoexp import diagnosis, registry
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


def not_compiled(settings: Settings, problem: Exception) -> StrategyError:
    """Return the error for a colony that cannot be compiled: the part at fault, why, and the author's line."""
    foreign, text = _foreign(settings), str(problem)
    places = {}
    for group in foreign:
        part = settings.parts[group]
        functions = [part.kernel.py_func, *diagnosis.compiled_functions(type(part))]
        places[group] = diagnosis.place_of(problem, _sources(settings, group), functions)
    faulty = (
        [group for group in foreign if repr(settings.parts[group].kernel.py_func) in text]
        or [group for group in foreign if places[group] is not None]
        or foreign
    )
    who = " or ".join(told(settings, group) for group in faulty) or _colony(settings)
    place = next((places[group] for group in faulty if places[group] is not None), None)
    return StrategyError(f"{who} cannot be compiled: {diagnosis.explain(problem)}{_at(place)}")


def raised(settings: Settings, seed: int, problem: Exception) -> StrategyError:
    """Return the error for a kernel that raised, which kernels may not do."""
    foreign = _foreign(settings)
    places = {group: diagnosis.raised_at(problem, _sources(settings, group)) for group in foreign}
    group = next((group for group in foreign if places[group] is not None), None)
    who = f"a kernel of {_colony(settings)}" if group is None else f"the kernel of {told(settings, group)}"
    at = f"; {suspects(settings)}" if group is None and foreign else _at(places.get(group or ""))
    return StrategyError(f"{who} raised, seed {seed}: {type(problem).__name__}: {problem}{at}")


def failed(settings: Settings, group: str, method: str, problem: Exception) -> StrategyError:
    """Return the error for a method of a part that raised."""
    what = f"{type(problem).__name__}: {problem}"
    place = diagnosis.raised_at(problem, _sources(settings, group))
    return StrategyError(f"{told(settings, group)} failed in {method}: {what}{_at(place)}")


def suspects(settings: Settings) -> str:
    """Return the words for the parts one of which broke the contract: those that are not built in, and tested."""
    foreign = _foreign(settings)
    acting = [group for group, part in settings.parts.items() if getattr(part, "kernel", None) is not None]
    who = " or ".join(told(settings, group) for group in foreign or acting)
    return f"most likely {who}" if foreign else who


def culprit(settings: Settings, group: str) -> str:
    """Return the words for the part that broke the contract, if it came to light in the part of this group.

    A kernel that writes where it may not makes others fail.
    """
    foreign = _foreign(settings)
    if group in foreign or not foreign:
        return told(settings, group)
    return f"{suspects(settings)} ({told(settings, group)} is built in)"


def packages_of(settings: Settings) -> dict[str, str]:
    """Return by group the package, with its version, that registers its part; a group is left out if none does."""
    packages = {group: _package(settings, group) for group in settings.parts}
    return {group: package for group, package in packages.items() if package is not None}


def _foreign(settings: Settings) -> list[str]:
    """Return the groups whose part acts while a trial runs, and is not a built-in one."""
    own = __name__.partition(".")[0]
    acting = {group: part for group, part in settings.parts.items() if getattr(part, "kernel", None) is not None}
    return [group for group, part in acting.items() if type(part).__module__.partition(".")[0] != own]


def _sources(settings: Settings, group: str) -> list[Path]:
    part = settings.parts[group]
    return diagnosis.sources_of(type(part), getattr(part, "kernel", None))


def _at(place: diagnosis.Place | None) -> str:
    return "" if place is None else f"; {place}"


def _colony(settings: Settings) -> str:
    parts = []
    for group, name in settings.names.items():
        package = _package(settings, group)
        foreign = package is not None and not package.startswith("acoexp ")
        parts.append(f"{group}={name}" + (f" of {package}" if foreign else ""))
    return f"the colony ({', '.join(parts)})"


def _package(settings: Settings, group: str) -> str | None:
    return registry.package_of(group, type(settings.parts[group]))
