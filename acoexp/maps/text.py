"""Maps as text: ASCII art, or 0 and 1 separated by blanks.

Lines that start with ``;`` are remarks; one of the form ``; key: value`` is metadata.
"""

from __future__ import annotations

from acoexp.errors import MapError, shown
from acoexp.grid.grid import Cell, Grid

_MARKS = {"S": 0, "G": 0}
_ART = {".": 0, "#": 1, **_MARKS}
_DIGITS = {"0": 0, "1": 1, **_MARKS}


def parse_map(
    text: str, *, name: str, start: Cell | None = None, goal: Cell | None = None, moves: str | None = None
) -> Grid:
    """Return the grid that a text shows.

    Args:
        text: Rows of ``.`` (free), ``#`` (obstacle), ``S`` and ``G`` (start and goal, on free cells), or of
            ``0`` and ``1`` separated by blanks, with the same marks.
        name: The map's name, for messages; a file's map is called like the file.
        start: Start, if the text does not mark it.
        goal: Goal, if the text does not mark it.
        moves: Rule for diagonals; else the text's own ``; moves:`` line, else ``no_squeeze``.

    Raises:
        MapError: if the text is empty, ragged, holds other symbols, marks start or goal twice or against
            the arguments, or the map is not one to plan on.
    """
    metadata, rows = _split(text)
    if not rows:
        raise MapError(f"map {name}: expected rows of '.' and '#' or of 0 and 1; got an empty text")
    symbols = [row.split() if " " in row.strip() or "\t" in row.strip() else list(row.strip()) for row in rows]
    first = next((symbol for row in symbols for symbol in row if symbol not in _MARKS), ".")
    alphabet = _DIGITS if first[0] in "01" else _ART
    for number, row in enumerate(symbols, 1):
        if len(row) != len(symbols[0]):
            raise MapError(
                f"map {name}: row {number} has {len(row)} cells; expected {len(symbols[0])}, as in row 1"
            )
        for col, symbol in enumerate(row, 1):
            if symbol not in alphabet:
                expected = " ".join(alphabet)
                raise MapError(
                    f"map {name}: row {number}, column {col}: expected one of {expected}; got {shown(symbol)}"
                )
    return Grid(
        [[alphabet[symbol] for symbol in row] for row in symbols],
        start=_marked("S", "start", symbols, start, name),
        goal=_marked("G", "goal", symbols, goal, name),
        moves=metadata.get("moves", "no_squeeze") if moves is None else moves,
        name=name,
        metadata=metadata,
    )


def _split(text: str) -> tuple[dict[str, str], list[str]]:
    metadata, rows = {}, []
    for line in text.splitlines():
        if line.lstrip().startswith(";"):
            key, colon, value = line.lstrip()[1:].partition(":")
            if colon:
                metadata[key.strip().lower()] = value.strip()
        elif line.strip():
            rows.append(line)
    return metadata, rows


def _marked(mark: str, key: str, symbols: list[list[str]], given: Cell | None, name: str) -> Cell | None:
    found = [(r, c) for r, row in enumerate(symbols) for c, symbol in enumerate(row) if symbol == mark]
    if len(found) > 1:
        raise MapError(f"map {name}: {mark} marks the {key}; expected it once, got it {len(found)} times")
    if found and given is not None and tuple(given) != found[0]:
        raise MapError(
            f"map {name}: {mark} stands at {found[0]}, but {key} {shown(tuple(given))} was given; drop one"
        )
    return found[0] if found else given
