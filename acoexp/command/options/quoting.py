"""Quoting: any text as a value that Hydra takes for just this text, and as a word that a shell hands on."""

from __future__ import annotations

import os
import re
import shlex
from typing import Any


def literal(value: Any) -> Any:
    """Return values, however nested, with texts in which OmegaConf sees no reference to another key."""
    if isinstance(value, dict):
        return {key: literal(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [literal(inner) for inner in value]
    return re.sub(r"(\\*)\$\{", r"\1\1\\${", value) if isinstance(value, str) else value


def hydra_text(text: str) -> str:
    """Return a text in quotes, as a value that Hydra's grammar and OmegaConf's leave as it is."""
    text = str(literal(text))
    mark = "'" if '"' in text and "'" not in text else '"'
    inside = re.sub(rf"(\\*){mark}", rf"\1\1\\{mark}", text)  # backslashes count before a mark, and nowhere else
    closing = inside[len(inside.rstrip("\\")) :]
    return f"{mark}{inside}{closing}{mark}"


def shell_word(text: str) -> str:
    """Return a text as one word that a person can see and paste into bash."""
    return shlex.quote(text) if text.isprintable() else f"$'{''.join(map(_escaped, text))}'"


def _escaped(sign: str) -> str:
    if sign.isprintable() and sign not in "'\\":
        return sign
    return "".join(f"\\x{byte:02x}" for byte in os.fsencode(sign))
