"""Configurations written as texts, such as ``pdg diffusion.gamma=0.02``."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from acoexp.compare.overrides import nested
from acoexp.console.plain import printable
from acoexp.errors import SettingsError, StrategyError, shown
from acoexp.registry.resolve import resolve
from acoexp.trial.settings import Settings

_NAMED = re.compile(r"([^:=]*[^:= ]) ?: ?(.*)")


class Configuration(NamedTuple):
    """One configuration to be compared.

    Attributes:
        label: What it is called in tables: its name, or else its text.
        text: Its preset and overrides.
        settings: What it resolves to.
    """

    label: str
    text: str
    settings: Settings


def parse_configurations(texts: Sequence[str], base: Mapping[str, Any]) -> list[Configuration]:
    """Return the configurations that texts describe.

    Args:
        texts: Each a preset's name and overrides ``key=value``, separated by blanks; before them there may be a
            name for it and a colon, as in ``mine: pdg diffusion=mine``.
        base: Settings that hold for all of them unless a text says otherwise.

    Raises:
        SettingsError: for a text that does not describe a configuration, fewer than two, or one given twice.
        StrategyError: for a part whose package cannot be imported.
    """
    parsed = [_parse(printable(" ".join(text.split())), base) for text in texts]
    labels = [one.label for one in parsed]
    if len(labels) < 2 or len(set(labels)) < len(labels):
        raise SettingsError(f"report.cells: expected two or more, each different; got {shown(labels)}")
    return parsed


def _parse(text: str, base: Mapping[str, Any]) -> Configuration:
    named = _NAMED.fullmatch(text)
    label, described = (named[1], named[2]) if named else (text, text)
    algo, *overrides = described.split() or [""]
    try:
        given = nested(overrides)
        merged = {**base, **given}
        if isinstance(base.get("field"), Mapping) and isinstance(given.get("field"), Mapping):
            merged["field"] = {**base["field"], **given["field"]}
        return Configuration(label, described, resolve(algo, merged))
    except (SettingsError, StrategyError) as problem:
        raise type(problem)(f"report.cells: {shown(text)}: {problem}") from problem
