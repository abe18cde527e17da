"""The page of a comparison as Markdown and HTML, its tables as LaTeX (booktabs)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape

from acoexp.report.render import html_page, html_table, markdown_table, markdown_text
from acoexp.report.table import Table

_LATEX = {
    **{mark: rf"\{mark}" for mark in "&%$#_{}"},
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "±": r"$\pm$", "∞": r"$\infty$", "<": "$<$", ">": "$>$", "--": "-{}-",
}  # fmt: skip
_LATEX_MARKS = re.compile(r"--|[\\~^&%$#_{}±∞<>]")


def as_markdown(title: str, lead: str, tables: Sequence[Table], picture: str) -> str:
    """Return a page with all tables and a link to the picture."""
    blocks = [f"# {markdown_text(title)}", markdown_text(lead)]
    for table in tables:
        blocks += [f"## {markdown_text(table.title)}", markdown_text(table.note), markdown_table(table)]
    blocks += ["## Convergence", f"![Median and quartiles of the best length in each cycle]({picture})"]
    return "\n\n".join(blocks) + "\n"


def as_html(title: str, lead: str, tables: Sequence[Table], svg: str) -> str:
    """Return a page that needs no other file: tables, and the picture's SVG text within."""
    body = [f"<h1>{escape(title)}</h1>", f"<p>{escape(lead)}</p>"]
    for table in tables:
        body += [f"<h2>{escape(table.title)}</h2>", f"<p>{escape(table.note)}</p>", html_table(table)]
    body += ["<h2>Convergence</h2>", "<p>Median and quartiles of the best length in each cycle.</p>"]
    body += [svg[svg.index("<svg") :]]
    return html_page(title, body)


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
