"""Arguments: flags and overrides in any order, ranges of seeds, and what Hydra would misread told apart."""

from __future__ import annotations

import re
from datetime import datetime
from secrets import token_hex
from typing import NamedTuple

from hydra._internal.utils import get_args_parser
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.errors import OverrideParseException

from acoexp.colony.problem import ColonySettings
from acoexp.errors import SettingsError
from acoexp.parameters import fields_of

_RANGES = re.compile(r"\d+(-\d+)?(,\d+(-\d+)?)*")
_WHOLE_KEYS = {"seed", *(name for name, field in fields_of(ColonySettings).items() if field.type == "int")}


class Arguments(NamedTuple):
    """What Hydra gets, and the user's folder of options, which it gets in another way."""

    argv: list[str]
    config_dir: str | None


def normalise(argv: list[str]) -> Arguments:
    """Return the arguments in the form that Hydra takes.

    Overrides may stand on both sides of flags; ``a-b`` and ``a-b,c`` become lists of whole numbers for the
    keys that are whole numbers; each run and sweep gets a folder of its own.

    Raises:
        SettingsError: for an override that cannot be read, a sweep without ``-m``, a range that runs
            backwards, or a flag that would replace the program's own configuration.
    """
    flags = get_args_parser().parse_intermixed_args(argv)
    for flag, value in (("--config-path", flags.config_path), ("--config-name", flags.config_name)):
        if value is not None:
            raise SettingsError(
                f"{flag}: expected overrides, or a folder with options of your own by --config-dir; got {value!r}"
            )
    overrides = [_expand(override) for override in flags.overrides]
    runs = not (flags.cfg or flags.info or flags.help or flags.hydra_help or flags.shell_completion)
    if runs and not flags.multirun:
        _refuse_sweeps(flags.overrides, overrides)
    options = list(argv)
    for override in flags.overrides:
        options.remove(override)
    if flags.config_dir is not None:
        options = _without_config_dir(options)
    # overrides first: an option with an optional value, such as --info, must not take one for its value
    return Arguments([*overrides, *(_folders(overrides) if runs else ()), *options], flags.config_dir)


def _expand(override: str) -> str:
    """Write the ranges of an override such as ``seed=0-4,7`` out."""
    key, _, value = override.partition("=")
    if key not in _WHOLE_KEYS or not _RANGES.fullmatch(value) or "-" not in value:
        return override
    numbers: list[int] = []
    for part in value.split(","):
        first, _, last = part.partition("-")
        if last and int(last) < int(first):
            raise SettingsError(f"{key}: expected a range from low to high, such as 0-9; got {part!r}")
        numbers.extend(range(int(first), int(last or first) + 1))
    return f"{key}={','.join(map(str, numbers))}"


def _refuse_sweeps(given: list[str], overrides: list[str]) -> None:
    try:
        parsed = OverridesParser.create().parse_overrides(overrides)
    except OverrideParseException as problem:
        raise SettingsError(str(problem).splitlines()[0]) from problem
    if any(override.key_or_group == "hydra.mode" for override in parsed):
        return
    for text, override in zip(given, parsed, strict=True):
        if override.is_sweep_override():
            raise SettingsError(f"{text}: several values; add -m to run them all (a list is written [1,2])")


def _folders(overrides: list[str]) -> list[str]:
    """Return overrides that give this run or sweep a folder of its own, unless the user names one."""
    stamp = f"{datetime.now():%Y-%m-%d/%H-%M-%S}-{token_hex(4)}"
    folders = {"hydra.run.dir": f"outputs/runs/{stamp}", "hydra.sweep.dir": f"outputs/sweeps/{stamp}"}
    return [f"{k}={v}" for k, v in folders.items() if not any(o.startswith(f"{k}=") for o in overrides)]


def _without_config_dir(options: list[str]) -> list[str]:
    kept, skip = [], False
    for option in options:
        if skip:
            skip = False
        elif option in ("--config-dir", "-cd"):
            skip = True
        elif not option.startswith("--config-dir="):
            kept.append(option)
    return kept
