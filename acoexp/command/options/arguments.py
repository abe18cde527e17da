"""Arguments: flags and overrides in any order, ranges of numbers, and what Hydra would misread told apart."""

from __future__ import annotations

import re
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

from hydra.core.override_parser.types import ChoiceSweep, Override

from acoexp.command.options.flags import flags_parser, split_arguments, without_config_dir
from acoexp.command.options.folders import own_folders
from acoexp.command.options.keys import OPTIONS
from acoexp.command.options.quoting import hydra_text
from acoexp.command.options.reading import (
    check_options,
    check_texts,
    line_to_type,
    read,
    takes_text,
    takes_whole_number,
)
from acoexp.errors import SettingsError, shown
from acoexp.registry.entries import GROUPS
from acoexp.strategies.groups import STRATEGY_GROUPS
from acoexp.trial.seeds import parse_seeds

_RANGES = re.compile(r"\d{1,20}(-\d{1,20})?(,\d{1,20}(-\d{1,20})?)*")

MOST_VALUES, MOST_JOBS = 100_000, 1_000_000
"""Values that one key of a sweep may have, and combinations of them all; each job costs Hydra some 50 ms."""


class Arguments(NamedTuple):
    """What Hydra gets; the user's folder of options, which it gets in another way; what flags of its own ask."""

    argv: list[str]
    config_dir: str | None
    info: str | None = None
    cfg: str | None = None
    help: bool = False


def normalise(argv: list[str]) -> Arguments:
    """Return the arguments in the form that Hydra takes.

    Overrides may stand on both sides of flags; ``a-b`` and ``a-b,c`` become lists of whole numbers for the
    keys that are whole numbers; each run and sweep gets a folder of its own.

    Raises:
        SettingsError: for an override that cannot be read, or not as it was meant; for a sweep without ``-m``, or
            with too many jobs; for a range that runs backwards; or for a flag that would replace the program's own
            configuration.
    """
    _check_signs(argv)
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
    overrides = [_quote_seeds(override) or override for override in given]
    mode = _mode(given)
    if flags.multirun and mode == "RUN":
        raise SettingsError("expected only one of --multirun and hydra.mode=RUN")
    several = flags.multirun or mode == "MULTIRUN"
    parsed = read(overrides, several)
    check_options(parsed)
    check_texts(overrides, several)
    overrides = list(map(_expand, overrides))
    _check_sizes(parsed, overrides)
    _refuse_seed_with_seeds(overrides)
    others = (flags.cfg, flags.info, flags.help, flags.hydra_help, flags.shell_completion)
    if sum(map(bool, (*others, flags.run, flags.multirun))) > 1 and not (flags.help and flags.cfg):
        raise SettingsError("expected only one of --run, --multirun, --cfg, --info, --help and -sc")
    runs = not any(others)
    if runs and not flags.multirun:
        _refuse_engines(overrides)
    if runs and not several:
        _refuse_sweeps(given, overrides)
    if flags.multirun:
        overrides = _defer_part_keys(overrides)
    # overrides first: an option with an optional value, such as --info, must not take one for its value
    argv = [*overrides, *(own_folders(overrides) if runs else ()), *without_config_dir(options)]
    return Arguments(argv, flags.config_dir, flags.info, flags.cfg, flags.help)


def _mode(given: list[str]) -> str | None:
    """Return what Hydra's own key says of a sweep.

    Raises:
        SettingsError: if it is not what Hydra knows.
    """
    said = [value for key, _, value in (override.partition("=") for override in given) if key == "hydra.mode"]
    for value in said:
        if value not in ("RUN", "MULTIRUN"):
            raise SettingsError(f"hydra.mode: expected RUN or MULTIRUN; got {shown(value)}")
    return said[-1] if said else None


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
    """Write the ranges of an override such as ``seed=0-4,7`` or ``map.seed=0-4`` out."""
    key, _, value = override.partition("=")
    if not _RANGES.fullmatch(value) or "-" not in value or not takes_whole_number(key):
        return override
    numbers: list[int] = []
    for part in value.split(","):
        first, _, last = part.partition("-")
        if last and int(last) < int(first):
            raise SettingsError(f"{key}: expected a range from low to high, such as 0-9; got {part!r}")
        numbers.extend(range(int(first), min(int(last or first), int(first) + MOST_VALUES) + 1))
        if len(numbers) > MOST_VALUES:
            raise SettingsError(f"{key}: expected at most {MOST_VALUES} values, each a job; got {shown(value)}")
    return f"{key}={','.join(map(str, numbers))}"


def _check_sizes(parsed: list[Override], overrides: list[str]) -> None:
    """Refuse a sweep that would never end; another sweeper chooses from what is given, however much."""
    if any(override.startswith("hydra/sweeper=") for override in overrides):
        return
    jobs = 1
    for override, expanded in zip(parsed, overrides, strict=True):
        number = _number_of_values(override) if override.input_line == expanded else expanded.count(",") + 1
        if number > MOST_VALUES:
            raise SettingsError(f"{override.input_line}: expected at most {MOST_VALUES} values, each a job")
        jobs *= max(number, 1)
    if jobs > MOST_JOBS:
        raise SettingsError(f"expected a sweep of at most {MOST_JOBS} jobs; got {jobs}; seeds=0-999 is one job")


def _number_of_values(override: Override) -> int:
    sweep: Any = override.value()
    if not override.is_range_sweep():
        return len(sweep.list) if isinstance(sweep, ChoiceSweep) else 1
    try:
        return int((sweep.stop - sweep.start) / sweep.step)
    except (ArithmeticError, ValueError):  # by steps of nothing, or without an end
        return MOST_VALUES + 1


def _refuse_engines(overrides: list[str]) -> None:
    for override in overrides:
        if override.startswith("engine=") and override != "engine=basic":
            raise SettingsError(f"{override}: an engine runs the jobs of a sweep; expected -m with it")


def _refuse_sweeps(given: list[str], overrides: list[str]) -> None:
    for text, override in zip(given, read(overrides), strict=True):
        if override.is_sweep_override():
            key, _, value = text.partition("=")
            one = f"; for a single one type {line_to_type(key, value)}" if takes_text(key) else ""
            raise SettingsError(f"{text}: several values; add -m to run them all{one}")


def _defer_part_keys(overrides: list[str]) -> list[str]:
    """Write ``diffusion.keep=1`` as a sweep of one value where the diffusion is swept.

    Else Hydra would look for that parameter in the part that there is before the sweep, too.
    """
    groups = (*GROUPS, "algo")
    of_parts = [text for text in overrides if re.split(r"[.=]", text)[0] in groups]
    sweeps = {override.key_or_group for override in read(of_parts) if override.is_sweep_override()}
    swept = sweeps | ({*STRATEGY_GROUPS} if "algo" in sweeps else set())
    texts = []
    for text in overrides:
        key, _, value = text.partition("=")
        waits = text in of_parts and "." in key and key not in sweeps and key.partition(".")[0] in swept and value
        texts.append(_deferred(key, value) if waits else text)
    return texts


def _deferred(key: str, value: str) -> str:
    """Return a sweep of one value; Hydra's ``choice`` forgets quotes, so a text may need them twice."""
    for form in (value, hydra_text(value)):
        with suppress(SettingsError):
            (override,) = read([f"{key}=choice({form})"])
            (handed_on,) = override.sweep_string_iterator()
            if read([f"{key}={handed_on}"])[0].value() == read([f"{key}={value}"])[0].value():
                return f"{key}=choice({form})"
    group = key.partition(".")[0]
    raise SettingsError(
        f"{key}: expected a value that Hydra can hand on where {group} is swept; got {value}; run each {group} by "
        "itself"
    )


def _check_signs(argv: list[str]) -> None:
    """Refuse names that nothing can be written with, and a working directory that Hydra would misread."""
    try:
        home = str(Path.cwd())
    except FileNotFoundError:
        raise SettingsError("expected a working directory; the one that acoexp was started in is gone") from None
    for text in (*argv, home):
        try:
            text.encode()
        except UnicodeEncodeError:
            raise SettingsError(f"expected arguments and a working directory in UTF-8; got {text!r}") from None
    if "${" in home:
        raise SettingsError(
            f"expected a working directory without '${{' in its name, by which Hydra refers to keys; got {home}; "
            "run acoexp in another"
        )


def _require_value(override: str) -> None:
    """Refuse what Hydra would stumble over: no key, or no option for a group."""
    key, _, value = override.lstrip("+~").partition("=")
    if not key:
        raise SettingsError(f"{override}: expected key=value")
    if key in OPTIONS and (value.lower() in ("", "null") or value[0] == "["):
        raise SettingsError(f"{key}: expected one of the options that --help lists; got {value!r}")
