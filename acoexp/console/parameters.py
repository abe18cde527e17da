"""Parameters as a person reads them: the one place where help is made of declarations."""

from __future__ import annotations

import inspect
from typing import Any

from acoexp.parameters import fields_of


def summary_of(owner: type) -> str:
    """Return what a class is, in one line: the first of its docstring."""
    return (inspect.getdoc(owner) or "").partition("\n")[0]


def described_parameters(owner: type, prefix: str = "") -> dict[str, str]:
    """Return each parameter's meaning by its key, with its default and what else it may be, if few things.

    Args:
        owner: A dataclass that declares parameters.
        prefix: Put before each name, such as ``"diffusion."``.
    """
    lines = {}
    for name, field in fields_of(owner).items():
        others = [choice for choice in field.metadata["choices"] or () if choice != field.default]
        values = shown_default(field.default) + (f", or {', '.join(others)}" if others else "")
        lines[prefix + name] = f"{field.metadata['meaning']} [{values}]"
    return lines


def shown_default(value: Any) -> str:
    """Return a default as the command line would take it."""
    if isinstance(value, tuple):
        return ", ".join(map(str, value))
    if isinstance(value, bool):
        return str(value).lower()
    return "null" if value is None else str(value)


def in_columns(lines: dict[str, str]) -> str:
    """Return keys and their meanings as lines of two columns."""
    width = max(map(len, lines), default=0)
    return "".join(f"  {key:<{width}}  {text}\n" for key, text in lines.items())
