"""Print the floors of the house, from the top down: each room with its purpose and what it stands on.

    python docs/floors.py

docs/contributing.md shows what this prints; the floors themselves stand in pyproject.toml, where lint-imports
holds them.
"""

from __future__ import annotations

import ast
import textwrap
import tomllib
from functools import cache
from pathlib import Path

import grimp

ROOT = Path(__file__).parents[1]
PACKAGE = "acoexp"
WIDTH = 110


@cache
def graph() -> grimp.ImportGraph:
    """Return who imports whom, file by file; imports within functions and for types count."""
    return grimp.build_graph(PACKAGE, exclude_type_checking_imports=False, cache_dir=None)


def floors() -> list[list[str]]:
    """Return the rooms of each floor, the top floor first."""
    config = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    layers = next(c for c in config["tool"]["importlinter"]["contracts"] if c["type"] == "layers")["layers"]
    return [[room.strip() for room in layer.replace(":", "|").split("|")] for layer in layers]


def room_of(module: str) -> str:
    """Return the room that a file is in."""
    return module.split(".")[1] if "." in module else ""


def purpose(room: str) -> str:
    """Return what a room is for: the first sentence of its docstring."""
    folder = ROOT / PACKAGE / room
    file = folder / "__init__.py" if folder.is_dir() else folder.with_suffix(".py")
    return (ast.get_docstring(ast.parse(file.read_text(encoding="utf-8"))) or "").partition("\n")[0]


def stands_on(room: str) -> list[str]:
    """Return the rooms whose files those of a room import."""
    own = [module for module in graph().modules if room_of(module) == room]
    others = {room_of(found) for module in own for found in graph().find_modules_directly_imported_by(module)}
    return sorted(others - {room, "", "errors", "parameters"})


def longest_chain() -> list[str]:
    """Return the longest chain of files each of which imports the next."""

    @cache
    def below(module: str) -> tuple[str, ...]:
        chains = [below(found) for found in sorted(graph().find_modules_directly_imported_by(module))]
        return (module, *max(chains, key=len, default=()))

    return list(max(map(below, sorted(graph().modules)), key=len))


def picture() -> str:
    """Return the floors as text."""
    lines = []
    for number, rooms in zip(range(len(floors()), 0, -1), floors(), strict=True):
        lines.append(f"{number} {'-' * (WIDTH - 2)}")
        for room in rooms:
            suffix = "/" if (ROOT / PACKAGE / room).is_dir() else ".py"
            lines.append(f"  {room + suffix:<14}{purpose(room)}")
            lines += [f"{'':<16}on {', '.join(below)}" for below in [stands_on(room)] if below]
    chain = [module.removeprefix(f"{PACKAGE}.") for module in longest_chain()]
    return "\n".join([*lines, "-" * WIDTH, f"The longest chain of imports, {len(chain)} files:", *_wrapped(chain)])


def _wrapped(chain: list[str]) -> list[str]:
    return textwrap.wrap(" > ".join(chain), WIDTH, initial_indent="  ", subsequent_indent="  ")


if __name__ == "__main__":
    print(picture())
