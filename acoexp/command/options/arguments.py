"""Arguments: flags and overrides in any order, ranges of seeds, and what Hydra would misread told apart."""

from __future__ import annotations

import re
from datetime import datetime
from secrets import token_hex
from typing import NamedTuple

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import Override
from hydra.errors import OverrideParseException

from acoexp.colony.scalars import ColonySettings
from acoexp.command.options.flags import flags_parser, split_arguments, without_config_dir
from acoexp.command.options.keys import JobKeys
from acoexp.errors import SettingsError
from acoexp.parameters import fields_of
from acoexp.registry.entries import GROUPS
from acoexp.strategies.groups import STRATEGY_GROUPS
from acoexp.trial.seeds import parse_seeds

_RANGES = re.compile(r"\d+(-\d+)?(,\d+(-\d+)?)*")
_WHOLE_KEYS = {
    name for owner in (JobKeys, ColonySettings) for name, field in fields_of(owner).items() if field.type == "int"
}


MOST_JOBS = 100_000
"""Values that one key of a sweep may have; each job costs Hydra some 50 ms."""


class Arguments(NamedTuple):
    """What Hydra gets, the user's folder of options, which it gets in another way, and what --info asks for."""

    argv: list[str]
    config_dir: str | None
    info: str | None = None


def normalise(argv: list[str]) -> Arguments:
    """Return the arguments in the form that Hydra takes.

    Overrides may stand on both sides of flags; ``a-b`` and ``a-b,c`` become lists of whole numbers for the
    keys that are whole numbers; each run and sweep gets a folder of its own.

    Raises:
        SettingsError: for an override that cannot be read, a sweep without ``-m``, a range that runs
            backwards, or a flag that would replace the program's own configuration.
    """
    parser = flags_parser()
    given, options = split_arguments(argv, parser)
    flags = parser.parse_args(options)
    replaced = {
        "--config-path": flags.config_path,
        "--config-name": flags.config_name,
        "--experimental-rerun": flags.experimental_rerun,
    }
    for flag, value in replaced.items():
        if value is not None:
            raise SettingsError(
                f"{flag}: expected overrides, or a folder with options of your own by --config-dir; got {value!r}"
            )
    for override in given:
        _require_value(override)
    overrides = [_quote_seeds(override) or _expand(override) for override in given]
    _refuse_seed_with_seeds(overrides)
    others = (flags.cfg, flags.info, flags.help, flags.hydra_help, flags.shell_completion)
    if sum(map(bool, (*others, flags.run, flags.multirun))) > 1 and not (flags.help and flags.cfg):
        raise SettingsError("expected only one of --run, --multirun, --cfg, --info, --help and -sc")
    runs = not any(others)
    if runs and not flags.multirun:
        _refuse_engines(overrides)
        _refuse_sweeps(given, overrides)
    if flags.multirun:
        overrides = _defer_part_keys(overrides)
    # overrides first: an option with an optional value, such as --info, must not take one for its value
    argv = [*overrides, *(_folders(overrides) if runs else ()), *without_config_dir(options)]
    return Arguments(argv, flags.config_dir, flags.info)


def _quote_seeds(override: str) -> str | None:
    """Return ``seeds=0-9,20`` as one text for one batch, which Hydra will not take for several values."""
    key, equals, value = override.partition("=")
    if key.lstrip("+") != "seeds" or not equals or value.lower() == "null":
        return None
    return f"{key}='{parse_seeds(value.strip(chr(39) + chr(34)))}'"


def _refuse_seed_with_seeds(overrides: list[str]) -> None:
    given = {override.lstrip("+").partition("=")[0]: override for override in overrides}
    if "seed" in given and "seeds" in given and given["seeds"] != "seeds=null":
        raise SettingsError(
            f"expected seed for trials, each a run, or seeds for a batch, one run; got {given['seed']} "
            f"and {given['seeds']}"
        )


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
        numbers.extend(range(int(first), min(int(last or first), int(first) + MOST_JOBS) + 1))
    if len(numbers) > MOST_JOBS:
        raise SettingsError(f"{key}: expected at most {MOST_JOBS} values, each a job; got {value!r}")
    return f"{key}={','.join(map(str, numbers))}"


def _refuse_engines(overrides: list[str]) -> None:
    for override in overrides:
        if override.startswith("engine=") and override != "engine=basic":
            raise SettingsError(f"{override}: an engine runs the jobs of a sweep; expected -m with it")


def _refuse_sweeps(given: list[str], overrides: list[str]) -> None:
    parsed = _parsed(overrides)
    if any(override.key_or_group == "hydra.mode" for override in parsed):
        return
    for text, override in zip(given, parsed, strict=True):
        if override.is_sweep_override():
            raise SettingsError(f"{text}: several values; add -m to run them all")


def _defer_part_keys(overrides: list[str]) -> list[str]:
    """Write ``diffusion.keep=1`` as a sweep of one value where the diffusion is swept.

    Else Hydra would look for that parameter in the part that there is before the sweep, too.
    """
    groups = (*GROUPS, "algo")
    of_parts = [text for text in overrides if re.split(r"[.=]", text)[0] in groups]
    sweeps = {override.key_or_group for override in _parsed(of_parts) if override.is_sweep_override()}
    swept = sweeps | ({*STRATEGY_GROUPS} if "algo" in sweeps else set())
    texts = []
    for text in overrides:
        key, _, value = text.partition("=")
        waits = text in of_parts and "." in key and key not in sweeps and key.partition(".")[0] in swept and value
        texts.append(f"{key}=choice({value})" if waits else text)
    return texts


def _parsed(overrides: list[str]) -> list[Override]:
    try:
        return OverridesParser.create().parse_overrides(overrides)
    except OverrideParseException as problem:
        raise SettingsError(str(problem).splitlines()[0]) from problem


def _require_value(override: str) -> None:
    """Refuse what Hydra would stumble over: no key, or no option for a group."""
    key, _, value = override.lstrip("+~").partition("=")
    if not key:
        raise SettingsError(f"{override}: expected key=value")
    if key in (*GROUPS, "algo", "tracking", "engine") and (value.lower() in ("", "null") or value[0] == "["):
        raise SettingsError(f"{key}: expected one of the options that --help lists; got {value!r}")


def _folders(overrides: list[str]) -> list[str]:
    """Return overrides that give this run or sweep a folder of its own, unless the user names one."""
    stamp = f"{datetime.now():%Y-%m-%d/%H-%M-%S}-{token_hex(4)}"
    folders = {"hydra.run.dir": f"outputs/runs/{stamp}", "hydra.sweep.dir": f"outputs/sweeps/{stamp}"}
    return [f"{k}={v}" for k, v in folders.items() if not any(o.startswith(f"{k}=") for o in overrides)]
