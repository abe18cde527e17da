"""Maps as text: ASCII art, or 0 and 1 with or without separators, or a matrix in brackets.

Lines that start with ``;`` are remarks; one of the form ``; key: value`` is metadata. Where cells are numbers
``%`` and ``#`` start remarks too; but not a ``#`` before nothing but cells, lest a row of ASCII art be lost.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from acoexp.errors import MapError, shown
from acoexp.grid.grid import Cell, Grid
from acoexp.maps.cells import FREE, GOAL, OBSTACLE, START, marked_grid
from acoexp.maps.matrix import entries, matrix_rows
from acoexp.maps.reading import check_size

_UNKNOWN = 255
_LONGEST_NUMBER = 40
_NUMBER = re.compile(r"[+-]?\d(\.\d*)?([eE][+-]?\d+)?", re.ASCII)
_REMARK = re.compile(r"\s*(%|#.*[^\s.#0-3SG,;])")


class _Art(dict[str, int]):
    """What each symbol stands for; ``_UNKNOWN`` for one that is none."""

    def __missing__(self, symbol: str) -> int:
        return _UNKNOWN


class _Numbers(dict[str, int]):
    """The same for numbers, however they are written: 1, 1.0, 1.000e+00, True."""

    def __missing__(self, symbol: str) -> int:
        word = symbol.strip()
        if len(word) > _LONGEST_NUMBER:
            return _UNKNOWN
        value = float(word) if _NUMBER.fullmatch(word) else _WORDS.get(word)
        if value not in (FREE, OBSTACLE, START, GOAL):
            return _UNKNOWN
        self[symbol] = int(value)
        return self[symbol]


_ART = {".": FREE, "#": OBSTACLE, "S": START, "G": GOAL}
_WORDS = {"False": FREE, "True": OBSTACLE, "false": FREE, "true": OBSTACLE, "S": START, "G": GOAL}
_DIGITS = {"0": FREE, "1": OBSTACLE, "2": START, "3": GOAL, "S": START, "G": GOAL}


def parse_map(
    text: str, *, name: str, start: Cell | None = None, goal: Cell | None = None, moves: str | None = None
) -> Grid:
    """Return the grid that a text shows.

    Args:
        text: Rows of ``.`` (free), ``#`` (obstacle), ``S`` and ``G`` (start and goal, on free cells); or of
            ``0``, ``1``, ``2`` and ``3`` for the same, between blanks, commas or semicolons, or with nothing
            between; or a matrix of these in brackets, as MATLAB or Python writes it (:mod:`acoexp.maps.matrix`).
        name: The map's name, for messages; a file's map is called like the file.
        start: Start, if the text does not mark it.
        goal: Goal, if the text does not mark it.
        moves: Rule for diagonals; else the text's own ``; moves:`` line, else ``no_squeeze``.

    Raises:
        MapError: if the text is empty, ragged, holds other symbols, marks start or goal twice or against
            the arguments, or the map is not one to plan on; or is larger than a file's map may be.
    """
    metadata, lines = _split(text)
    if not lines:
        raise MapError(f"map {name}: expected rows of '.' and '#' or of 0 and 1; got an empty text")
    rows, split, alphabet = _notation(lines, name)
    return marked_grid(
        _cells(rows, split, alphabet, name),
        ("S", "G") if alphabet == _ART else ("2 or S", "3 or G"),
        name=name,
        start=start,
        goal=goal,
        moves=metadata.get("moves") if moves is None else moves,
        metadata=metadata,
    )


def _split(text: str) -> tuple[dict[str, str], list[str]]:
    """Return the metadata and the other lines; within brackets ``;`` is between rows."""
    metadata, lines = {}, []
    brackets = False
    for line in text.splitlines():
        if line.lstrip().startswith(";") and not brackets:
            key, colon, value = line.lstrip()[1:].partition(":")
            if colon:
                metadata[key.strip().lower()] = value.strip()
        elif line.strip():
            lines.append(line)
            brackets = brackets or "[" in line
    return metadata, lines


def _notation(lines: list[str], name: str) -> tuple[list[str], Callable[[str], list[str]], dict[str, int]]:
    """Return the rows of a map, how a row is split into symbols, and what these stand for."""
    content = [line for line in lines if not _REMARK.match(line)]
    if any("[" in line for line in content):
        return matrix_rows("\n".join(lines), name), entries, _DIGITS
    first = next(filter(None, (line.lstrip(" \tSG,;") for line in content)), ".")
    return (content, _fields, _DIGITS) if first[0] in "0123" else (lines, _symbols, _ART)


def _symbols(row: str) -> list[str]:
    row = row.strip()
    return row.split() if " " in row or "\t" in row else list(row)


def _fields(row: str) -> list[str]:
    row = row.strip().removesuffix(";").removesuffix(",")
    separator = next((sign for sign in ",;" if sign in row), None)
    return _symbols(row) if separator is None else row.replace(f"{separator} ", separator).split(separator)


def _cells(
    rows: list[str], split: Callable[[str], list[str]], alphabet: dict[str, int], name: str
) -> NDArray[np.uint8]:
    """Return the cells of rows of symbols, uint8[rows, cols]."""
    width = len(split(rows[0]))
    check_size(len(rows), width, name)
    codes = _Art(alphabet) if alphabet == _ART else _Numbers(alphabet)
    found = bytearray()
    for number, row in enumerate(rows, 1):
        symbols = split(row)
        if len(symbols) != width:
            raise MapError(f"map {name}: row {number} has {len(symbols)} cells; expected {width}, as in row 1")
        cells = bytes(map(codes.__getitem__, symbols))
        if _UNKNOWN in cells:
            col = cells.index(_UNKNOWN)
            raise MapError(
                f"map {name}: row {number}, column {col + 1}: expected one of {' '.join(alphabet)}; got "
                f"{shown(symbols[col].strip())}"
            )
        found += cells
    return np.frombuffer(bytes(found), dtype=np.uint8).reshape(len(rows), width)
