"""The command that runs a job again, for whoever finds its run."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterable

from acoexp.console.plain import printable

_NOT_TOLD = re.compile(r"[+~]*(tracking|threads|resume)\b")
"""Where and how a job was run; an address may have a password in it."""

_QUOTED_SEEDS = re.compile("^seeds='([0-9,-]*)'$")
"""As Hydra is told of them."""


def command_of(overrides: Iterable[str], config_dir: str | None = None) -> str:
    """Return the command for a job that was told these overrides: one line, to be put into a shell.

    Args:
        overrides: What it was told.
        config_dir: The folder with a person's own option files, if it was told one.
    """
    told = [_QUOTED_SEEDS.sub(r"seeds=\1", override) for override in overrides if not _NOT_TOLD.match(override)]
    folder = [] if config_dir is None else ["--config-dir", config_dir]
    return printable(shlex.join(["python", "-m", "acoexp", *folder, *told]))
