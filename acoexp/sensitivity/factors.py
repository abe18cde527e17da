"""The keys that are varied, each with its span; and the configurations that they make."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from acoexp.errors import SettingsError, did_you_mean, shown
from acoexp.parameters import fields_of, kind_of, values_of
from acoexp.registry.resolve import resolve
from acoexp.sensitivity.span import Factor, Span, parse_span
from acoexp.trial.settings import Settings

MOST_KEYS = 20
"""Keys that one report may vary."""

_SCALARS = ("alpha", "beta", "rho")
"""Those that are varied when no keys are named, beside the numbers of the parts: ants and cycles are effort."""


class _Number(NamedTuple):
    """A number that settings have: its type, its value, and the bounds that it is declared with."""

    kind: type
    value: float | None
    bounds: Mapping[str, Any]


def parse_factors(texts: Sequence[str], algo: str, settings: Settings) -> list[Factor]:
    """Return the keys that texts name.

    Args:
        texts: Each a key, or a key and its span, as in ``rho=interval(0.1,0.9)``; without any they are alpha,
            beta, rho and the numbers of the parts.
        algo: The command line's preset.
        settings: Its settings.

    Raises:
        SettingsError: for a key that is no number of these settings, one named twice, too many of them, a span
            that cannot be read, and one with values that its key may not have.
    """
    known = _numbers(settings)
    factors = [_parse(text, known) for text in texts or _by_default(known)]
    keys = [factor.key for factor in factors]
    if len(keys) > MOST_KEYS or len(set(keys)) < len(keys):
        raise SettingsError(f"report.keys: expected at most {MOST_KEYS} keys, each once; got {shown(keys)}")
    for key, span, _ in factors:
        for end in (span.low, span.high):
            try:
                settings_with(settings, algo, {key: end})
            except SettingsError as problem:
                raise SettingsError(f"report.keys: {problem}") from problem
    return factors


def settings_with(settings: Settings, algo: str, values: Mapping[str, float]) -> Settings:
    """Return settings of a preset with other values of some of their numbers.

    Raises:
        SettingsError: for a value that its key may not have.
    """
    known = _numbers(settings)
    nested: dict[str, Any] = {**values_of(settings.scalars), "field": values_of(settings.field)}
    for group, chosen in settings.chosen.items():
        nested[group] = {"name": chosen.name, **values_of(chosen.part)}
    for key, value in values.items():
        group, _, name = key.rpartition(".")
        inner = nested[group] if group else nested
        inner[name] = known[key].kind(value)
    return resolve(algo, nested)


def _numbers(settings: Settings) -> dict[str, _Number]:
    """Return the numbers that settings have, by their keys."""
    parts = {f"{group}.": part for group, part in settings.parts.items()}
    owners = {"": settings.scalars, **parts, "field.": settings.field}
    return {
        prefix + name: _Number(kind_of(type(owner), name), getattr(owner, name), field.metadata)
        for prefix, owner in owners.items()
        for name, field in fields_of(type(owner)).items()
        if kind_of(type(owner), name) in (int, float)
    }


def _by_default(known: Mapping[str, _Number]) -> list[str]:
    """Return the keys that are varied when none are named: those that a span lies about."""
    of_parts = [key for key in known if "." in key and not key.startswith("field.")]
    return [key for key in (*_SCALARS, *of_parts) if _around(known[key]) is not None]


def _parse(text: str, known: Mapping[str, _Number]) -> Factor:
    key, equals, described = (part.strip() for part in text.partition("="))
    if key not in known:
        said = f"expected a key that is a number of this configuration, one of: {', '.join(known)}"
        raise SettingsError(f"report.keys: {shown(key)}: {said}{did_you_mean(key, known)}")
    number = known[key]
    try:
        span = parse_span(described, number.kind is int) if equals else _around(number)
    except ValueError as problem:
        raise SettingsError(f"report.keys: {shown(text)}: {problem}") from problem
    if span is None:
        said = f"expected a span, such as {key}=interval(1,2), as none lies about {number.value}"
        raise SettingsError(f"report.keys: {shown(text)}: {said}")
    return Factor(key, span, math.nan if number.value is None else float(number.value))


def _around(number: _Number) -> Span | None:
    """Return the span from half a number to twice it, within its bounds; None if there is none."""
    if number.value is None or number.value <= 0:
        return None
    minimum, maximum = number.bounds["minimum"], number.bounds["maximum"]
    whole = number.kind is int
    low = max(number.value // 2 if whole else number.value / 2.0, 1 if whole else 0.0, minimum or 0.0)
    high = min(number.value * 2, math.inf if maximum is None else maximum)
    above = number.bounds["above"]
    if not low < high or (above is not None and low <= above):
        return None
    return Span(float(low), float(high), log=True, whole=whole)
