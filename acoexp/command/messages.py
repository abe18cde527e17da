"""Errors as a person reads them: one line on standard error, Hydra's in our words."""

from __future__ import annotations

import re
import sys


def print_error(problem: Exception) -> None:
    """Print an error as one line."""
    print(f"acoexp: error: {in_one_line(problem)}", file=sys.stderr)


def in_one_line(problem: Exception) -> str:
    """Return an error's message as one line."""
    text = " ".join(str(problem).partition("Config search path")[0].split())
    unknown = re.match(r"Could not override '([^']+)'", text)
    if unknown:
        return f"{unknown[1]} is not a known key; --help lists the keys, --cfg job shows the settings"
    missing = re.match(r"In '[^']+': Could not find '([^/']+)/([^']+)' Available options in '[^']+': (.*)", text)
    if missing:
        return f"{missing[1]}: expected one of: {', '.join(missing[3].split())}; got {missing[2]!r}"
    return text or type(problem).__name__
