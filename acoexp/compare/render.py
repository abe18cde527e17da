"""Tables as LaTeX, with booktabs."""

from __future__ import annotations

import re
from collections.abc import Sequence

from acoexp.report.table import Table

_LATEX = {
    **{mark: rf"\{mark}" for mark in "&%$#_{}"},
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "±": r"$\pm$", "∞": r"$\infty$", "<": "$<$", ">": "$>$", "--": "-{}-",
    "²": "$^2$", "√": r"$\surd$", "τ": r"$\tau$", "χ": r"$\chi$",
}  # fmt: skip
_LATEX_MARKS = re.compile("--|[" + re.escape("".join(mark for mark in _LATEX if len(mark) == 1)) + "]")


def as_latex(tables: Sequence[Table]) -> str:
    """Return all tables for a document that loads booktabs."""
    return "% needs \\usepackage{booktabs}\n" + "\n".join(map(_tabular, tables))


def _tabular(table: Table) -> str:
    lines = [latex_row(row) for row in (table.headings, *table.rows)]
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


def latex_row(texts: Sequence[str]) -> str:
    """Return a row; the end of the one before would take a ``[`` or ``*`` at its beginning for its own."""
    row = " & ".join(map(latex_text, texts))
    return ("{}" if row.startswith(("[", "*")) else "") + row + r" \\"


def latex_text(text: str) -> str:
    """Return a text as LaTeX in which every sign stands for itself."""
    return _LATEX_MARKS.sub(lambda mark: _LATEX[mark[0]], " ".join(text.splitlines()))
