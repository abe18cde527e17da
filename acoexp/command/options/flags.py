"""Flags: what Hydra's own parser knows of them; it has no public door, so this is the one file that goes inside.

For hydra-core 1.3. Its parser says which flags there are and which take a value, so that overrides may stand on
both sides of them; and its completion completes no override behind ``-m``. tests/command/options/test_flags.py
fails when either changes.
"""

from __future__ import annotations

import re
from argparse import ArgumentParser
from collections.abc import MutableMapping
from typing import NoReturn

from hydra._internal.utils import get_args_parser

from acoexp.errors import SettingsError

PARTS_INFO = "strategies"
"""What ``--info`` shows of ours, besides what Hydra's own shows."""


def complete_past_flags(environment: MutableMapping[str, str]) -> None:
    """Take ``-m`` out of the line that a shell wants completed: Hydra completes no override behind it."""
    line = environment.get("COMP_LINE")
    if line is not None:
        environment["COMP_LINE"] = re.sub(r"\s(-m|--multirun)(?=\s)", "", line)
        environment["COMP_POINT"] = str(len(environment["COMP_LINE"]))


def flags_parser() -> ArgumentParser:
    """Return Hydra's parser, which tells of what is wrong in our way."""
    parser = get_args_parser()

    def refuse(message: str) -> NoReturn:
        raise SettingsError(f"{message}; --help lists what there is")

    parser.error = refuse  # type: ignore[method-assign]
    info = parser._option_string_actions["--info"]
    info.choices = [*(info.choices or ()), PARTS_INFO]
    return parser


def split_arguments(argv: list[str], parser: ArgumentParser) -> tuple[list[str], list[str]]:
    """Return overrides and flags apart, each flag with its value."""
    overrides, options = [], []
    words = list(reversed(argv))
    while words:
        word = words.pop()
        if not word.startswith("-"):
            overrides.append(word)
            continue
        word = _in_full(word, parser)
        options.append(word)
        action = parser._option_string_actions.get(word)
        takes = action is not None and action.nargs is None
        may_take = action is not None and action.nargs == "?"
        if words and (takes or (may_take and words[-1] in (action.choices or ()))):  # type: ignore[union-attr]
            options.append(words.pop())
    return overrides, options


def _in_full(flag: str, parser: ArgumentParser) -> str:
    """Return a flag that was shortened in full, as argparse would take it."""
    known = parser._option_string_actions
    longer = [name for name in known if flag.startswith("--") and name.startswith(flag)]
    return longer[0] if flag not in known and len(longer) == 1 else flag


def without_config_dir(options: list[str]) -> list[str]:
    """Return flags without the user's folder of options, which Hydra gets in another way."""
    kept, skip = [], False
    for option in options:
        if skip:
            skip = False
        elif option in ("--config-dir", "-cd"):
            skip = True
        elif not option.startswith(("--config-dir=", "-cd=")):
            kept.append(option)
    return kept
