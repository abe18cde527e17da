"""Tables as Markdown, HTML, LaTeX (booktabs); rows as CSV and JSON."""

from __future__ import annotations

import csv
import io
import json
import math
import re
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

from acoexp.compare.measures import Row
from acoexp.compare.tables import Table

_STYLE = """\
body { font: 16px/1.5 system-ui, sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem; color: #222; }
div { overflow-x: auto; }
table { border-collapse: collapse; border-top: 2px solid; border-bottom: 2px solid; font-size: .85rem; }
th { border-bottom: 1px solid; text-align: left; }
th, td { padding: .2rem .7rem; vertical-align: top; }
svg { max-width: 100%; height: auto; }
"""

_LATEX = {
    **{mark: rf"\{mark}" for mark in "&%$#_{}"},
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "±": r"$\pm$", "∞": r"$\infty$", "<": "$<$", ">": "$>$", "--": "-{}-",
}  # fmt: skip
_LATEX_MARKS = re.compile(r"--|[\\~^&%$#_{}±∞<>]")

_MARKDOWN_MARKS = re.compile(
    r"[\\`*$~|]"
    r"|<(?=[A-Za-z/!?])|&(?=#?\w+;)"  # HTML's tags and entities
    r"|\](?=\()"  # links
    r"|(?<![^\W_])_|_(?![^\W_])"  # but not within a word
)
"""What Markdown, as GitHub has it, takes for more than itself."""


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
    head = f'<meta charset="utf-8"><title>{escape(title)}</title>\n<style>\n{_STYLE}</style>'
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>{head}</head>\n<body>\n'
        + "\n".join(body)
        + "\n</body></html>\n"
    )


def as_latex(tables: Sequence[Table]) -> str:
    """Return all tables for a document that loads booktabs."""
    return "% needs \\usepackage{booktabs}\n" + "\n".join(map(_tabular, tables))


def markdown_table(table: Table) -> str:
    """Return a table alone, without its title and note, as Markdown."""
    lines = [_pipes(table.headings), _pipes(["---"] * len(table.headings)), *map(_pipes, table.rows)]
    return "\n".join(lines)


def markdown_text(text: str) -> str:
    """Return a text in one line of Markdown, in which every sign stands for itself."""
    return _MARKDOWN_MARKS.sub(r"\\\g<0>", " ".join(text.splitlines()))


def html_table(table: Table) -> str:
    """Return a table alone as HTML; where it is too wide it scrolls within its ``div``."""
    head = "".join(f"<th>{escape(text)}</th>" for text in table.headings)
    rows = ("".join(f"<td>{escape(text)}</td>" for text in row) for row in table.rows)
    lines = "\n".join(f"<tr>{row}</tr>" for row in rows)
    return f"<div><table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{lines}\n</tbody></table></div>"


def as_csv(rows: Sequence[Row]) -> str:
    """Return rows with their keys as a head; empty where there is no value."""
    text = io.StringIO()
    writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows({key: _plain(value) for key, value in row.items()} for row in rows)
    return text.getvalue()


def as_json(content: Any) -> str:
    """Return nested content; null where there is no value, ``"inf"`` for infinity."""
    return json.dumps(_plain(content), indent=1, allow_nan=False, ensure_ascii=False) + "\n"


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if not isinstance(value, float) or math.isfinite(value):
        return value
    return None if math.isnan(value) else "inf"


def _pipes(texts: Sequence[str]) -> str:
    return "| " + " | ".join(map(markdown_text, texts)) + " |"


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
