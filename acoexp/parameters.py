"""Parameters: declared once on a frozen dataclass, then read by validation, Hydra, ``--help`` and docs alike.

@dataclass(frozen=True, kw_only=True)
class Gaussian(Diffusion):
    gamma: float = parameter(0.01, "diffusion coefficient", minimum=0.0, maximum=1.0)
"""

from __future__ import annotations

import dataclasses
import sys
import types
import typing
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from acoexp.errors import SettingsError, did_you_mean, shown

_KINDS: dict[Any, str] = {
    float: "a number",
    int: "a whole number",
    str: "a text",
    bool: "true or false",
    tuple[str, ...]: "a list of texts",
    tuple[int, int]: "a pair [row, column]",
    tuple[float, float]: "a pair [x, y]",
}
"""The types that a parameter may have, each also with ``| None``, and what messages call them."""

REQUIRED = "???"
"""Default of a parameter that must be given; also OmegaConf's mark for a missing value."""


def parameter(
    default: Any,
    meaning: str,
    *,
    minimum: float | None = None,
    maximum: float | None = None,
    above: float | None = None,
    choices: tuple[str, ...] | None = None,
) -> Any:
    """Declare one parameter as a dataclass field.

    Args:
        default: Its value when nothing is said, or ``REQUIRED``.
        meaning: One line for ``--help`` and the docs, with the unit if there is one.
        minimum: Smallest value allowed.
        maximum: Largest value allowed.
        above: Bound that a value must exceed.
        choices: The only values allowed, for a string.
    """
    bounds = {"minimum": minimum, "maximum": maximum, "above": above, "choices": choices}
    return dataclasses.field(default=default, metadata={"meaning": meaning, **bounds})


def fields_of(owner: type) -> dict[str, dataclasses.Field[Any]]:
    """Return the parameters that a dataclass declares, by name, in order of declaration."""
    fields = dataclasses.fields(owner) if dataclasses.is_dataclass(owner) else ()
    return {f.name: f for f in fields if "meaning" in f.metadata}


def defaults_of(owner: type) -> dict[str, Any]:
    """Return each parameter's default, by name."""
    return {name: f.default for name, f in fields_of(owner).items()}


def values_of(owner: Any) -> dict[str, Any]:
    """Return the value of each parameter of an instance, by name; none for one that declares none."""
    return {name: getattr(owner, name) for name in fields_of(type(owner))}


def build(owner: type, values: Mapping[str, Any], prefix: str = "") -> Any:
    """Make an instance of ``owner`` from plain values, each checked against its declaration.

    Args:
        owner: A dataclass whose fields were made by :func:`parameter`.
        values: Values by parameter name; what is missing takes its default.
        prefix: Put before a name in messages, such as ``"diffusion."``.

    Raises:
        SettingsError: for an unknown name, a missing value, a wrong type, or a value out of range.
    """
    checked = check(owner, {**defaults_of(owner), **values}, prefix)
    try:
        return owner(**checked)
    except (SettingsError, KeyboardInterrupt):
        raise
    except BaseException as problem:  # its own __post_init__ refuses them
        where = prefix.rstrip(".") or owner.__name__
        raise SettingsError(f"{where}: {type(problem).__name__}: {problem}; got {checked}") from problem


def check(owner: type, values: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Return values, each as the type that its parameter declares; raises as :func:`build` does."""
    declared, hints = fields_of(owner), typing.get_type_hints(owner)
    for name in values:
        if name not in declared:
            known = ", ".join(prefix + other for other in declared) or "none: it has no parameters"
            like = did_you_mean(name, declared)
            raise SettingsError(f"{prefix}{name} is not a known key; expected one of: {known}{like}")
    return {n: _checked(prefix + n, value, hints[n], declared[n]) for n, value in values.items()}


def kind_of(owner: type, name: str) -> Any:
    """Return the type that a parameter has where it is not None."""
    return _kind(typing.get_type_hints(owner)[name])


def check_declarations(owner: type) -> None:
    """Refuse a dataclass whose fields are not all parameters of types that a value can be checked for.

    Raises:
        SettingsError: if so.
    """
    if any(isinstance(value, dataclasses.Field) for value in vars(owner).values()):
        raise SettingsError(
            f"{owner.__name__} has parameters, but no @dataclass(frozen=True, kw_only=True) above it"
        )
    if not dataclasses.is_dataclass(owner):
        return
    try:
        hints = typing.get_type_hints(owner)
    except Exception as problem:
        reason = f"{type(problem).__name__}: {problem}"
        raise SettingsError(f"the types of the fields of {owner.__name__} are not known: {reason}") from problem
    for field in dataclasses.fields(owner):
        if "meaning" not in field.metadata:
            raise SettingsError(f"{field.name} is a field without parameter()")
        if _kind(hints[field.name]) not in _KINDS:
            known = ", ".join(str(getattr(kind, "__name__", kind)) for kind in (float, int, str, bool))
            raise SettingsError(
                f"{field.name}: expected one of the types {known}, tuple[str, ...], tuple[int, int] and "
                f"tuple[float, float], or one of them | None; got {hints[field.name]}"
            )


def expected(hint: Any, field: dataclasses.Field[Any]) -> str:
    """Say in words which values a parameter takes, such as ``a number from 0 to 1``."""
    rules = field.metadata
    if rules["choices"]:
        return "one of: " + ", ".join(rules["choices"])
    words = _KINDS[_kind(hint)]
    if rules["minimum"] is not None and rules["maximum"] is not None:
        return f"{words} from {_shown(rules['minimum'])} to {_shown(rules['maximum'])}"
    if rules["minimum"] is not None:
        return f"{words}, at least {rules['minimum']:g}"
    if rules["above"] is not None:
        upto = "" if rules["maximum"] is None else f", at most {_shown(rules['maximum'])}"
        return f"{words} above {rules['above']:g}{upto}"
    if rules["maximum"] is not None:
        return f"{words}, at most {_shown(rules['maximum'])}"
    return words


def _checked(key: str, value: Any, hint: Any, field: dataclasses.Field[Any]) -> Any:
    """Return ``value`` as its declared type, or raise."""
    if value is None and type(None) in typing.get_args(hint):
        return None
    converted = _converted(value, _kind(hint))
    if converted is None or not _within(converted, field.metadata):
        came = "nothing" if value is None or _is_missing(value) else shown(value)
        raise SettingsError(f"{key}: expected {expected(hint, field)}; got {came}")
    return converted


def _kind(hint: Any) -> Any:
    """Return what a parameter is where it is not None."""
    if typing.get_origin(hint) not in (typing.Union, types.UnionType):
        return hint
    kinds = [kind for kind in typing.get_args(hint) if kind is not type(None)]
    return kinds[0] if len(kinds) == 1 else hint


def _converted(value: Any, kind: Any) -> Any:
    """Return ``value`` as ``kind``, or None where that would change what it says."""
    if _is_missing(value):
        return None
    if typing.get_origin(kind) is tuple:
        return _texts(value) if kind == tuple[str, ...] else _pair(value, typing.get_args(kind)[0])
    if isinstance(value, np.generic):
        item = value.item()  # a long double stays one
        return _converted(float(item) if isinstance(item, np.floating) else item, kind)
    if kind is float and not isinstance(value, bool) and isinstance(value, int | float):
        return float(value) if abs(value) <= sys.float_info.max else None
    if kind is int and (isinstance(value, bool) or not isinstance(value, int)):
        return None
    return value if isinstance(value, kind) else None


def _shown(bound: float) -> str:
    if bound == 2**64 - 1:
        return "2^64 - 1"
    return f"{bound:.0f}" if 1.0 <= bound < 1e7 and bound == int(bound) else f"{bound:g}"


def _is_missing(value: Any) -> bool:
    return isinstance(value, str) and value == REQUIRED


def _pair(value: Any, kind: type) -> tuple[Any, Any] | None:
    """Return a pair as a tuple of two numbers of one kind, or None."""
    if not isinstance(value, Sequence | np.ndarray) or isinstance(value, str) or len(value) != 2:
        return None
    first, second = (_converted(part, kind) for part in value)
    return None if first is None or second is None else (first, second)


def _texts(value: Any) -> tuple[str, ...] | None:
    """Return a list of texts as a tuple, or None."""
    if not isinstance(value, list | tuple) or not all(isinstance(text, str) for text in value):
        return None
    return tuple(value)


def _within(value: Any, rules: Mapping[str, Any]) -> bool:
    if rules["choices"]:
        return value in rules["choices"]
    return not (
        (rules["minimum"] is not None and value < rules["minimum"])
        or (rules["maximum"] is not None and value > rules["maximum"])
        or (rules["above"] is not None and value <= rules["above"])
    )
