"""The folders that runs and sweeps get of their own, and how they are told from those that a person names."""

from __future__ import annotations

import re
from collections.abc import Iterable
from datetime import datetime
from secrets import token_hex

_OWN_RUN = re.compile(r"outputs/runs/\d{4}-\d\d-\d\d/\d\d-\d\d-\d\d-[0-9a-f]{8}")


def own_folders(overrides: Iterable[str]) -> list[str]:
    """Return overrides that give this run or sweep a folder of its own, unless the user names one."""
    stamp = f"{datetime.now():%Y-%m-%d/%H-%M-%S}-{token_hex(4)}"
    folders = {"hydra.run.dir": f"outputs/runs/{stamp}", "hydra.sweep.dir": f"outputs/sweeps/{stamp}"}
    named = {override.lstrip("+").partition("=")[0] for override in overrides}
    return [f"{key}={folder}" for key, folder in folders.items() if key not in named]


def is_named(run_folder: str) -> bool:
    """Tell whether a run's folder was named by the user."""
    return _OWN_RUN.fullmatch(run_folder) is None
