"""Tables as LaTeX, with booktabs."""

from __future__ import annotations

import re
from collections.abc import Sequence

from acoexp.report.table import Table

_LATEX = {
    **{mark: rf"\{mark}" for mark in "&%$#_{}"},
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "±": r"$\pm$", "∞": r"$\infty$", "<": "$<$", ">": "$>$", "--": "-{}-",
}  # fmt: skip
_LATEX_MARKS = re.compile(r"--|[\\~^&%$#_{}±∞<>]")


def as_latex(tables: Sequence[Table]) -> str:
    """Return all tables for a document that loads booktabs."""
    return "% needs \\usepackage{booktabs}\n" + "\n".join(map(_tabular, tables))


def _tabular(table: Table) -> str:
    lines = [_tex_row(row) for row in (table.headings, *table.rows)]
    return "\n".join(
        [
            f"% {table.title}. {table.note}",
            rf"\begin{{tabular}}{{{'l' * len(table.headings)}}}",
            r"\toprule",
            lines[0],
            r"\midrule",
            *lines[1:],
            r"\bottomrule",
            r"\end{tabular}",
            "",
        ]
    )


def _tex_row(texts: Sequence[str]) -> str:
    """Return a row; the end of the one before would take a ``[`` or ``*`` at its beginning for its own."""
    row = " & ".join(map(_tex, texts))
    return ("{}" if row.startswith(("[", "*")) else "") + row + r" \\"


def _tex(text: str) -> str:
    return _LATEX_MARKS.sub(lambda mark: _LATEX[mark[0]], " ".join(text.splitlines()))
