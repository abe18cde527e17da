"""Errors as a person reads them: one line on standard error, Hydra's in our words."""

from __future__ import annotations

import re
import sys

_EXTRAS = {
    "hydra/launcher/joblib": ("engine", "joblib"),
    "hydra/launcher/submitit_slurm": ("engine", "slurm"),
    "hydra/launcher/ray": ("engine", "ray"),
    "hydra/sweeper/optuna": ("hydra/sweeper", "optuna"),
}
"""What comes with an extra: its group, and the name that it and the extra have."""


def print_error(problem: Exception) -> None:
    """Print an error as one line."""
    print(f"acoexp: error: {in_one_line(problem)}", file=sys.stderr)


def in_one_line(problem: Exception) -> str:
    """Return an error's message as one line."""
    text = " ".join(str(problem).partition("Config search path")[0].split())
    unknown = re.match(r"Could not override '([^']+)'", text)
    if unknown:
        return f"{unknown[1]} is not a known key; --help lists the keys, --cfg job shows the settings"
    lacking = re.search("Could not find '(hydra/(?:launcher|sweeper)/\\w+)'", text)
    if lacking and lacking[1] in _EXTRAS:
        group, name = _EXTRAS[lacking[1]]
        return f"{group}: {name} needs `pip install acoexp[{name}]`"
    missing = re.match(r"In '[^']+': Could not find '([^/']+)/([^']+)' Available options in '[^']+': (.*)", text)
    if missing:
        return f"{missing[1]}: expected one of: {', '.join(missing[3].split())}; got {missing[2]!r}"
    return text or type(problem).__name__
