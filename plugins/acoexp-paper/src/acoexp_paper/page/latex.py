"""The tables as LaTeX: one file each, and one document on A4 with all of them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from acoexp.compare.render import latex_row, latex_text
from acoexp.report.table import Table

_PREAMBLE = r"""\documentclass[a4paper]{article}
\usepackage[utf8]{inputenc}
\usepackage[margin=20mm]{geometry}
\usepackage{array,booktabs,caption,longtable,pdflscape}
\captionsetup{labelformat=empty,justification=raggedright,singlelinecheck=false,font=footnotesize}
\setlength{\LTleft}{0pt}
\begin{document}
"""
_PORTRAIT, _LANDSCAPE = 170.0, 257.0
"""Millimetres between the margins of an A4 page."""

_BETWEEN = 2.2
"""Millimetres between two columns."""

_NARROW, _WIDE = 1.5, 2.3
"""Millimetres that a sign takes in a small font, at most."""

_LONG = 16.0
"""Millimetres above which the entries of a column are broken into lines, where that is needed."""

_LINES = 3.0
"""Lines of an entry, on average of its column, above which a table is turned to have more room."""


def as_document(names: Iterable[str]) -> str:
    """Return a document that takes in the files of all tables, which lie beside it."""
    return _PREAMBLE + "".join(rf"\input{{{name}}}" + "\n\n" for name in names) + "\\end{document}\n"


def as_latex(table: Table) -> str:
    """Return a table with its caption, which may go over pages; one that is too wide is turned."""
    widths, turned = _layout(table)
    columns = "".join(rf">{{\raggedright\arraybackslash}}p{{{width:.1f}mm}}" for width in widths)
    headings = latex_row(table.headings)
    lines = [
        "% needs: array, booktabs, caption, longtable, pdflscape",
        r"\begingroup\footnotesize" + rf"\setlength{{\tabcolsep}}{{{_BETWEEN / 2:.1f}mm}}",
        *([r"\begin{landscape}"] if turned else []),
        rf"\begin{{longtable}}{{@{{}}{columns}@{{}}}}",
        rf"\caption{{\textbf{{{latex_text(table.title)}}} {latex_text(table.note)}}} \\",
        rf"\toprule {headings} \midrule \endfirsthead",
        rf"\toprule {headings} \midrule \endhead",
        r"\bottomrule \endfoot",
        *map(_row, table.rows),
        r"\end{longtable}",
        *([r"\end{landscape}"] if turned else []),
        r"\endgroup",
    ]
    return "\n".join(lines) + "\n"


def _row(texts: Sequence[str]) -> str:
    """Return a row, an average set off from those that it is of."""
    row = latex_row(texts)
    return rf"\midrule {row} \midrule" if texts[0] == "Average result" else row


def _layout(table: Table) -> tuple[list[float], bool]:
    """Return the widths of the columns, in millimetres, and whether the page must be turned."""
    columns = list(zip(table.headings, *table.rows, strict=True))
    least = [max(_width(word) for text in texts for word in text.split() or [""]) for texts in columns]
    whole = [max(low, *map(_width, texts[1:])) for low, texts in zip(least, columns, strict=True)]
    room = _PORTRAIT - _BETWEEN * (len(columns) - 1)
    if sum(whole) <= room:
        return whole, False
    upright = _shared(least, whole, room)
    if upright is not None and max(want / got for want, got in zip(whole, upright, strict=True)) <= _LINES:
        return upright, False
    turned = _LANDSCAPE - _BETWEEN * (len(columns) - 1)
    if sum(whole) <= turned:
        return whole, True
    return _shared(least, whole, turned) or least, True


def _shared(least: Sequence[float], whole: Sequence[float], room: float) -> list[float] | None:
    """Return widths that fill the room, short columns whole, long ones in proportion; None if it is too small."""
    short = [want if want <= _LONG else low for low, want in zip(least, whole, strict=True)]
    spare = room - sum(short)
    if spare < 0:
        return None
    missing = [want - low for low, want in zip(short, whole, strict=True)]
    share = min(1.0, spare / (sum(missing) or 1.0))
    return [low + share * more for low, more in zip(short, missing, strict=True)]


def _width(text: str) -> float:
    return sum(_WIDE if sign.isupper() or sign in "mw%+=<>&" else _NARROW for sign in text)
