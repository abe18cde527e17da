"""Configurations written as texts, such as ``pdg diffusion.gamma=0.02``."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from omegaconf import OmegaConf
from omegaconf.errors import OmegaConfBaseException
from yaml import YAMLError

from acoexp.console.plain import printable
from acoexp.errors import SettingsError, StrategyError, shown
from acoexp.registry.resolve import resolve
from acoexp.strategies.groups import STRATEGY_GROUPS
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
        raise SettingsError(f"report.cells: expected two or more, each different; got {labels}")
    return parsed


def _parse(text: str, base: Mapping[str, Any]) -> Configuration:
    named = _NAMED.fullmatch(text)
    label, described = (named[1], named[2]) if named else (text, text)
    algo, *overrides = described.split() or [""]
    try:
        given = _nested(overrides)
        merged = {**base, **given}
        if isinstance(base.get("field"), Mapping) and isinstance(given.get("field"), Mapping):
            merged["field"] = {**base["field"], **given["field"]}
        return Configuration(label, described, resolve(algo, merged))
    except (SettingsError, StrategyError) as problem:
        raise type(problem)(f"report.cells: {shown(text)}: {problem}") from problem


def _nested(overrides: Sequence[str]) -> dict[str, Any]:
    """Return ``key=value`` texts as nested settings; a part's name stands under ``name``."""
    dotted = []
    for override in overrides:
        key, equals, value = override.partition("=")
        if not key or not equals:
            raise SettingsError(f"expected key=value; got {shown(override)}")
        dotted.append(f"{key}.name={value}" if key in STRATEGY_GROUPS else override)
    try:
        nested = OmegaConf.to_container(OmegaConf.from_dotlist(dotted), resolve=False)
    except (OmegaConfBaseException, YAMLError, ValueError, TypeError) as problem:
        reason = str(problem).splitlines()[0]
        raise SettingsError(f"expected key=value, as on the command line; {reason}") from problem
    return {str(key): value for key, value in nested.items()} if isinstance(nested, dict) else {}
