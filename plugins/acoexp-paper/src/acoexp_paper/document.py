"""The document: sections of paragraphs, lists, tables and figures, rendered as a page of HTML and of Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from html import escape
from typing import NamedTuple

from acoexp.report.render import html_table, markdown_table
from acoexp.report.tables import Table


class Text(NamedTuple):
    """A paragraph."""

    text: str


class Bullets(NamedTuple):
    """A list."""

    items: Sequence[str]


class Numbers(NamedTuple):
    """A table, and the name of its files."""

    name: str
    table: Table


class Figure(NamedTuple):
    """A figure, by the name of its files, and what it shows."""

    name: str
    caption: str


Block = Text | Bullets | Numbers | Figure


class Section(NamedTuple):
    """A section."""

    title: str
    blocks: Sequence[Block]


class Document(NamedTuple):
    """The whole."""

    title: str
    lead: str
    sections: Sequence[Section]


def tables_in(document: Document) -> dict[str, Table]:
    """Return all tables by name."""
    blocks = (block for section in document.sections for block in section.blocks)
    return {block.name: block.table for block in blocks if isinstance(block, Numbers)}


def as_markdown(document: Document) -> str:
    """Return the document as Markdown, its figures as links to their files."""
    parts = [f"# {document.title}", document.lead]
    for section in document.sections:
        parts += [f"## {section.title}", *map(_markdown, section.blocks)]
    return "\n\n".join(parts) + "\n"


def _markdown(block: Block) -> str:
    match block:
        case Text(text):
            return text
        case Bullets(items):
            return "\n".join(f"- {item}" for item in items)
        case Numbers(_, table):
            return f"**{table.title}**\n\n{table.note}\n\n{markdown_table(table)}"
        case Figure(name, caption):
            return f"![{caption}](figures/{name}.svg)\n\n*{caption}*"


def as_html(document: Document, drawings: dict[str, str]) -> str:
    """Return the document as one page that needs no other file.

    Args:
        document: The document.
        drawings: The SVG text of each figure, by name.
    """
    links = "\n".join(f'<li><a href="#{_id(s.title)}">{escape(s.title)}</a></li>' for s in document.sections)
    parts = [f"<h1>{escape(document.title)}</h1>", f'<p class="lead">{escape(document.lead)}</p>']
    parts += [f"<nav><ol>\n{links}\n</ol></nav>"]
    for section in document.sections:
        parts += [f'<section id="{_id(section.title)}">', f"<h2>{escape(section.title)}</h2>"]
        parts += [html for block in section.blocks for html in _html(block, drawings)]
        parts += ["</section>"]
    head = f'<meta charset="utf-8">\n<meta name="viewport" content="width=device-width">\n<title>{escape(document.title)}</title>'
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>{head}\n<style>\n{_STYLE}</style>\n</head>\n<body>\n'
        + "\n".join(parts)
        + "\n</body>\n</html>\n"
    )


def _html(block: Block, drawings: dict[str, str]) -> Iterator[str]:
    match block:
        case Text(text):
            yield f"<p>{escape(text)}</p>"
        case Bullets(items):
            yield "<ul>" + "\n".join(f"<li>{escape(item)}</li>" for item in items) + "</ul>"
        case Numbers(name, table):
            yield f'<figure class="table" id="{name}"><figcaption><b>{escape(table.title)}</b> {escape(table.note)}</figcaption>'
            yield _coloured(html_table(table))
            yield "</figure>"
        case Figure(name, caption):
            svg = drawings[name]
            yield f'<figure id="{name}">{svg[svg.index("<svg") :]}<figcaption>{escape(caption)}</figcaption></figure>'


def _coloured(html: str) -> str:
    """Mark verdicts, numbers and rows of averages for the style."""
    classes = {
        "holds": "yes", "yes": "yes", "does not hold": "no", "no": "no", "opposite": "against", "depends on the map": "mixed",
    }  # fmt: skip
    for text, name in classes.items():
        html = html.replace(f"<td>{text}</td>", f'<td class="{name}">{text}</td>')
    html = re.sub(r"<tr><td>Average result", '<tr class="average"><td>Average result', html)
    return re.sub(r"<td>([-+<]? ?[\d.]+(?: \[.*?\])?(?:/\d+)?(?: %)?)</td>", r'<td class="number">\1</td>', html)


def _id(title: str) -> str:
    return re.sub(r"\W+", "-", title.lower()).strip("-")


_STYLE = """\
body { font: 16px/1.5 "Source Serif 4", Georgia, "DejaVu Serif", serif; max-width: 62rem; margin: 2rem auto; padding: 0 1.2rem; color: #1a1a1a; }
h1, h2, nav, table, figcaption { font-family: system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.25; }
h2 { font-size: 1.25rem; margin-top: 2.5rem; border-bottom: 1px solid #bbb; padding-bottom: .2rem; }
.lead { font-size: 1.05rem; }
nav ol { columns: 2; font-size: .9rem; }
a { color: #0072B2; }
figure { margin: 1.5rem 0; break-inside: avoid; }
figure.table { break-inside: auto; }
figure > div { overflow-x: auto; }
figcaption { font-size: .82rem; line-height: 1.4; color: #333; margin: .4rem 0; }
table { border-collapse: collapse; border-top: 2px solid #222; border-bottom: 2px solid #222; font-size: .78rem; line-height: 1.35; }
thead { border-bottom: 1px solid #222; }
th { text-align: left; }
th, td { padding: .18rem .6rem; vertical-align: top; }
td.number { font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.average { border-top: 1px solid #999; border-bottom: 1px solid #999; font-weight: 600; }
td.yes { background: #dcefe6; } td.no { background: #f1f1f1; } td.against { background: #f8dcd0; } td.mixed { background: #fbeecb; }
svg { max-width: 100%; height: auto; display: block; margin: 0 auto; }
@media print { body { max-width: none; margin: 0; font-size: 10pt; } table { font-size: 7.5pt; } nav { display: none; } }
"""
