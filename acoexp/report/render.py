"""What reports are written of: pages and tables as HTML and Markdown, rows as CSV and JSON."""

from __future__ import annotations

import csv
import io
import json
import math
import re
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

from acoexp.report.table import Table

_STYLE = """\
body { font: 16px/1.55 system-ui, sans-serif; max-width: 76rem; margin: 2.5rem auto; padding: 0 1.2rem; }
body { color: #222; background: #fff; color-scheme: light; }
h1 { font-size: 1.9rem; line-height: 1.2; margin-bottom: .3rem; }
h2 { font-size: 1.4rem; margin-top: 3rem; padding-bottom: .2rem; border-bottom: 1px solid #ddd; }
h3 { font-size: 1.05rem; margin: 2rem 0 .3rem; }
p.note, figcaption { font-size: .87rem; color: #555; max-width: 60rem; }
p.verdict { border-left: 5px solid #0072B2; background: #f2f7fb; padding: .8rem 1.1rem; font-size: 1.06rem; }
nav { font-size: .92rem; } nav a { margin-right: 1.2rem; }
a { color: #0072B2; }
div { overflow-x: auto; }
table { border-collapse: collapse; border-top: 2px solid; border-bottom: 2px solid; font-size: .85rem; }
th { border-bottom: 1px solid; text-align: left; }
th, td { padding: .22rem .7rem; vertical-align: top; white-space: nowrap; font-variant-numeric: tabular-nums; }
tbody tr:nth-child(even) { background: #f7f7f7; }
figure { margin: 1.5rem 0; }
summary { cursor: pointer; font-weight: 600; margin: .8rem 0; }
svg { max-width: 100%; height: auto; }
"""

_MARKDOWN_MARKS = re.compile(
    r"[\\`*$~|]"
    r"|<(?=[A-Za-z/!?])|&(?=#?\w+;)"  # HTML's tags and entities
    r"|\](?=\()"  # links
    r"|(?<![^\W_])_|_(?![^\W_])"  # but not within a word
)
"""What Markdown, as GitHub has it, takes for more than itself."""


def html_page(title: str, body: Sequence[str]) -> str:
    """Return a page that needs no other file, of parts that are HTML already."""
    head = f'<meta charset="utf-8"><title>{escape(title)}</title>\n<style>\n{_STYLE}</style>'
    view = '<meta name="viewport" content="width=device-width, initial-scale=1">'
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>{head}{view}</head>\n<body>\n'
        + "\n".join(body)
        + "\n</body></html>\n"
    )


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


def as_csv(rows: Sequence[Mapping[str, Any]]) -> str:
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
