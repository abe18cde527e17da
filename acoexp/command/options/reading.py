"""Reading overrides by Hydra's grammar; what it cannot read, or reads as something else than a text, is told.

Names of files and folders hold signs that Hydra takes for its own: ``=``, ``,``, brackets, anything but ASCII. The
message then shows the line to type.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import Field
from pathlib import Path
from typing import Any

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import ChoiceSweep, Override, QuotedString
from hydra.errors import OverrideParseException
from omegaconf import OmegaConf
from omegaconf.errors import GrammarParseError

from acoexp.colony.scalars import ColonySettings
from acoexp.command.options.keys import OPTIONS, JobKeys, ReportKeys
from acoexp.command.options.quoting import hydra_text, shell_word
from acoexp.command.options.tuning import SAMPLERS, TuningKeys
from acoexp.errors import SettingsError, StrategyError, shown
from acoexp.grid.field import FieldSettings
from acoexp.parameters import expected, fields_of, kind_of
from acoexp.registry.entries import GROUPS, not_found, part_names
from acoexp.registry.parts import find_part
from acoexp.tracking.options import TRACKING

_FOLDERS = ("hydra.run.dir", "hydra.sweep.dir", "hydra.sweep.subdir")
_NOUNS = {bool: "true or false", int: "a number", float: "a number", list: "a list", dict: "a mapping"}
_OWNERS: dict[str, tuple[type, ...]] = {
    "": (JobKeys, ColonySettings),
    "field": (FieldSettings,),
    "report": (ReportKeys,),
    "tracking": tuple(TRACKING.values()),
    "hydra.sweeper": (TuningKeys,),
    "hydra.sweeper.sampler": tuple(SAMPLERS.values()),
}
"""What declares the keys that are of no part."""
_LONGEST = 200
"""Characters of a value that is shown as it is to be typed."""

_PARSER = OverridesParser.create()
_UNREADABLE = (OverrideParseException, GrammarParseError, ValueError, RecursionError)
"""What Hydra's grammar and OmegaConf's raise; ValueError is Python's, for thousands of digits."""


def read(overrides: Iterable[str], several: bool = False) -> list[Override]:
    """Return overrides as Hydra reads them.

    Args:
        overrides: As they were typed.
        several: Whether values may be several, separated by commas.

    Raises:
        SettingsError: for one that cannot be read.
    """
    return [_read(override, several) for override in overrides]


def check_options(overrides: Iterable[Override]) -> None:
    """Refuse what is read as a number or the like where an option is to be named, for which Hydra has no message.

    Raises:
        SettingsError: for the first of them.
    """
    for override in overrides:
        for value in _values(override) if override.key_or_group in OPTIONS else ():
            if value is not None and not isinstance(value, str):
                raise SettingsError(
                    f"{override.key_or_group}: expected one of the options that --help lists; got {shown(value)}"
                )


def check_texts(overrides: Iterable[str], several: bool) -> None:
    """Refuse what is read as a number, a list or the like, where only a text can be meant.

    Raises:
        SettingsError: for the first of them.
    """
    for override in overrides:
        key, _, value = override.partition("=")
        if takes_text(key):
            for part in _values(_read(override, several)):
                _check_text(key, value, part, several)


def takes_text(key: str) -> bool:
    """Tell whether only a text can be meant by a key's value."""
    kinds = {hint is str and not field.metadata["choices"] for hint, field in _declared(key)}
    return key.lstrip("+") in _FOLDERS or kinds == {True}


def takes_whole_number(key: str) -> bool:
    """Tell whether only a whole number can be meant by a key's value."""
    return {hint is int for hint, _ in _declared(key)} == {True}


def line_to_type(key: str, value: str, several: bool = False) -> str:
    """Return what to type into a shell so that a value is taken as the text that it is.

    Args:
        key: The key, with its ``+`` if it has one.
        value: The text, in quotes or without; a list of texts in brackets for a key that takes these.
        several: Whether commas separate several texts.
    """
    value = value[1:-1] if re.fullmatch("'.*'|\".*\"", value, re.DOTALL) else value
    if len(value) > _LONGEST:
        return f"{key}='\"...\"'"
    if value[:1] == "[" and value[-1:] == "]" and any(hint == tuple[str, ...] for hint, _ in _declared(key)):
        quoted = f"[{','.join(map(_item, value[1:-1].split(',')))}]"
    else:
        quoted = ",".join(hydra_text(_at_home(text)) for text in (value.split(",") if several else [value]))
    return shell_word(f"{key}={quoted}")


def _read(override: str, several: bool) -> Override:
    try:
        return _parsed(override)
    except _UNREADABLE as problem:
        raise SettingsError(_refusal(override, several)) from problem


def _parsed(override: str) -> Override:
    (parsed,) = _PARSER.parse_overrides([override])
    OmegaConf.create(_values(parsed))  # which has a grammar of its own, for ${...}
    return parsed


def _refusal(override: str, several: bool) -> str:
    """Say why an override cannot be read."""
    key, equals, value = override.partition("=")
    if not equals or not key.lstrip("+~") or not _is_read(f"{key}=0"):
        return f"{shown(override)}: expected key=value"
    if key in GROUPS and not several and value not in part_names(key):
        return not_found(key, value, part_names(key))
    declared = _declared(key)
    if declared and not any(hint in (str, tuple[str, ...]) for hint, _ in declared):
        return f"{key}: expected {expected(*declared[0])}; got {shown(value)}"
    line = line_to_type(key, value, several)
    return f"{key}: expected quotes, as Hydra reads signs in it as its own; got {value[:_LONGEST]}; type {line}"


def _is_read(override: str) -> bool:
    try:
        _parsed(override)
    except _UNREADABLE:
        return False
    return True


def _check_text(key: str, value: str, part: Any, several: bool) -> None:
    if part is None and key.lstrip("+") in _FOLDERS:
        raise SettingsError(f"{key}: expected a folder; got {value}")
    if isinstance(part, str) and not several and _loses_its_ends(value):
        line = line_to_type(key, value)
        raise SettingsError(
            f"{key}: expected quotes, as Hydra drops signs at its ends; got {value!r}; type {line}"
        )
    if part is not None and not isinstance(part, str):
        noun = _NOUNS.get(type(part), "something else")
        line = line_to_type(key, value, several)
        raise SettingsError(
            f"{key}: expected a text; got {value[:_LONGEST]}, which Hydra reads as {noun}; type {line}"
        )
    if key.lstrip("+") in _FOLDERS and isinstance(part, str):
        _check_folder(key, part)


def _loses_its_ends(value: str) -> bool:
    """Tell whether a text without quotes has blanks at an end, or backslashes that Hydra takes half of."""
    return value != value.strip() or value.endswith("\\\\")


def _check_folder(key: str, folder: str) -> None:
    """Refuse a folder that Hydra would take for another."""
    if re.match("~(/|$)", folder):
        line = line_to_type(key, folder)
        raise SettingsError(
            f"{key}: expected a folder; got {folder}, which Hydra would make in this one; type {line}"
        )
    if "\\${" in folder:
        raise SettingsError(
            f"{key}: expected a folder without '${{' in its name, by which Hydra refers to keys; got {folder}"
        )


def _values(parsed: Override) -> list[Any]:
    """Return an override's value, or those of a sweep."""
    if not parsed.is_sweep_override():
        return [parsed.value()]
    # what a pattern such as glob(*) stands for, only Hydra knows, later
    sweep: Any = parsed.value()
    several = sweep.list if isinstance(sweep, ChoiceSweep) else []
    return [one.text if isinstance(one, QuotedString) else one for one in several]


def _item(text: str) -> str:
    """Return an item of a list as it stands if Hydra can read it, else as a text."""
    text = text.strip()
    return text if _is_read(f"k={text}") else hydra_text(text.strip("'\""))


def _at_home(text: str) -> str:
    """Return a path in the home directory in full, which all can read."""
    try:
        return str(Path(text).expanduser()) if text.startswith("~/") else text
    except RuntimeError:
        return text


def _declared(key: str) -> list[tuple[Any, Field[Any]]]:
    """Return what is declared of a key: the type and the field, of each part that has such a parameter."""
    group, _, name = key.lstrip("+").rpartition(".")
    return [(kind_of(o, name), fields_of(o)[name]) for o in _owners(group) if name in fields_of(o)]


def _owners(group: str) -> Iterator[type]:
    """Yield the classes that declare the keys of a group; none for those of Hydra's."""
    yield from _OWNERS.get(group, ())
    for name in part_names(group) if group in GROUPS else ():
        try:
            yield find_part(group, name)
        except StrategyError:  # broken: whoever uses it is told
            continue
