"""Matrices in brackets: MATLAB's, and lists of lists as Python and JSON write them.

``map = [0 1 0; ...];`` has ``;`` or line ends between its rows, commas or blanks between its entries, and may go
on in the next line after ``...``; ``map = np.array([[0, 1], [1, 0]])`` has a list for each row. ``%`` and ``#``
start remarks.
"""

from __future__ import annotations

import re

from acoexp.errors import MapError, shown

_HEAD = re.compile(r"([A-Za-z_][\w.]* ?= ?)?([A-Za-z_][\w.]* ?\( ?)?")
_TAIL = re.compile(r"( ?, ?dtype ?= ?[\w.]+)? ?,? ?(\))? ?;?")


def matrix_rows(text: str, name: str) -> list[str]:
    """Return the rows of a matrix, each the text of its entries.

    Raises:
        MapError: if the text is not one matrix and nothing else.
    """
    head, _, rest = re.sub(r"[%#].*", "", text).partition("[")
    body, closing, tail = rest.rpartition("]")
    began, ended = (pattern.fullmatch(" ".join(part.split())) for pattern, part in ((_HEAD, head), (_TAIL, tail)))
    if not closing or began is None or ended is None or (began[2] is None) != (ended[2] is None):
        raise _refusal(text, name)
    rows = _lists(body) if "[" in body or "]" in body else _lines(body)
    if not rows:
        raise _refusal(text, name)
    return rows


def entries(row: str) -> list[str]:
    """Return the entries of a row, between commas if it has any, else between blanks."""
    row = row.strip().removesuffix(",")
    return row.replace(", ", ",").split(",") if "," in row else row.split()


def _lines(body: str) -> list[str]:
    """Return MATLAB's rows."""
    return [row for row in re.split("[;\n]", re.sub(r"\.\.\..*\n?", " ", body)) if row.strip()]


def _lists(body: str) -> list[str] | None:
    """Return Python's rows, which stand one after the other in brackets of their own; None if they do not."""
    parts = re.split(r"[][]", body)
    between = [part.strip() for part in parts[::2]]
    in_turn = re.sub(r"[^][]+", "", body).replace("[]", "") == ""
    apart = between[0] == "" and {*between[1:]} <= {"", ","}
    return parts[1::2] if in_turn and apart else None


def _refusal(text: str, name: str) -> MapError:
    return MapError(
        f"map {name}: expected one matrix and nothing else, such as [0 1; 0 0] or [[0, 1], [0, 0]]; got "
        f"{shown(text)}"
    )
