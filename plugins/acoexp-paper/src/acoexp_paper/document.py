"""The document: sections of paragraphs, lists, tables and figures, rendered as a page of HTML and of Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from html import escape
from importlib.resources import files
from typing import NamedTuple

from acoexp.report.render import html_table, markdown_table
from acoexp.report.tables import Table


class Text(NamedTuple):
    """A paragraph."""

    text: str


class Heading(NamedTuple):
    """A heading within a section."""

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


Block = Text | Heading | Bullets | Numbers | Figure


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
        case Heading(text):
            return f"### {text}"
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
    head = '<meta charset="utf-8">\n<meta name="viewport" content="width=device-width">\n'
    head += f"<title>{escape(document.title)}</title>"
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>{head}\n<style>\n{_STYLE}</style>\n</head>\n<body>\n'
        + "\n".join(parts)
        + "\n</body>\n</html>\n"
    )


def _html(block: Block, drawings: dict[str, str]) -> Iterator[str]:
    match block:
        case Text(text):
            yield f"<p>{escape(text)}</p>"
        case Heading(text):
            yield f"<h3>{escape(text)}</h3>"
        case Bullets(items):
            yield "<ul>" + "\n".join(f"<li>{escape(item)}</li>" for item in items) + "</ul>"
        case Numbers(name, table):
            yield f'<figure class="table" id="{name}">'
            yield f"<figcaption><b>{escape(table.title)}</b> {escape(table.note)}</figcaption>"
            yield _coloured(html_table(table))
            yield "</figure>"
        case Figure(name, caption):
            svg = drawings[name]
            yield f'<figure id="{name}">{svg[svg.index("<svg") :]}'
            yield f"<figcaption>{escape(caption)}</figcaption></figure>"


def _coloured(html: str) -> str:
    """Mark verdicts, numbers and rows of averages for the style."""
    classes = {
        "holds": "yes",
        "yes": "yes",
        "does not hold": "no",
        "no": "no",
        "opposite": "against",
        "depends on the map": "mixed",
    }
    for text, name in classes.items():
        html = html.replace(f"<td>{text}</td>", f'<td class="{name}">{text}</td>')
    html = re.sub(r"<tr><td>Average result", '<tr class="average"><td>Average result', html)
    number = r"(?:&lt; )?[\d.]+(?: \[[^]]*\])?(?: / \d+ / \d+|/\d+)?"
    return re.sub(f"<td>({number})</td>", r'<td class="number">\1</td>', html)


def _id(title: str) -> str:
    return re.sub(r"\W+", "-", title.lower()).strip("-")


_STYLE = files("acoexp_paper").joinpath("data", "style.css").read_text(encoding="utf-8")
