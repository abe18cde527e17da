"""The document as text: a page of HTML, Markdown, and a table as CSV."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Iterator, Mapping
from html import escape
from importlib.resources import files

from acoexp.report.render import html_table, markdown_table, markdown_text
from acoexp.report.table import Table
from acoexp_paper.claims.words import COMPATIBLE, CONTRADICTED, DEPENDS, SHOWN, UNDECIDED
from acoexp_paper.page.document import (
    Block,
    Bullets,
    Document,
    Figure,
    Heading,
    Numbers,
    References,
    Section,
    Source,
    Text,
    titles_in,
)

_STYLE = files("acoexp_paper.page").joinpath("style.css").read_text(encoding="utf-8")
_CLASSES = {
    SHOWN: "yes", COMPATIBLE: "yes", "yes": "yes", UNDECIDED: "no", "no": "no", CONTRADICTED: "against", DEPENDS:
        "mixed",
}  # fmt: skip
"""The style of a table's entry, by its text."""


def as_markdown(document: Document) -> str:
    """Return the document as Markdown, its figures as links to their files."""
    parts = [f"# {markdown_text(document.title)}", markdown_text(document.lead)]
    for section in document.sections:
        parts += [f"## {markdown_text(section.title)}", *map(_markdown, section.blocks)]
    return "\n\n".join(parts) + "\n"


def _markdown(block: Block) -> str:
    match block:
        case Text(text):
            return markdown_text(text)
        case Heading(text):
            return f"### {markdown_text(text)}"
        case Bullets(items):
            return "\n".join(f"- {markdown_text(item)}" for item in items)
        case References(items):
            return "\n".join(f"{place}. {_cited(item)}" for place, item in enumerate(items, 1))
        case Numbers(_, table):
            title, note = markdown_text(table.title), markdown_text(table.note)
            return f"**{title}**\n\n{note}\n\n{markdown_table(table)}"
        case Figure(name, title, caption):
            alternative = re.sub(r"(?<!\\)[][]", r"\\\g<0>", markdown_text(title))
            return f"![{alternative}](figures/{name}.svg)\n\n**{markdown_text(title)}.** {markdown_text(caption)}"


def _cited(source: Source) -> str:
    doi = f" [doi:{source.doi}](https://doi.org/{source.doi})" if source.doi else ""
    return markdown_text(source.text) + doi


def as_html(document: Document, drawings: Mapping[str, str]) -> str:
    """Return the document as one page that needs no other file.

    Args:
        document: The document.
        drawings: The SVG text of each figure, by name.
    """
    head = '<meta charset="utf-8">\n<meta name="viewport" content="width=device-width">\n'
    head += f"<title>{escape(document.title)}</title>"
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>{head}\n<style>\n{_STYLE}</style>\n</head>\n<body>\n'
        + "\n".join(_body(document, drawings))
        + "\n</body>\n</html>\n"
    )


def _body(document: Document, drawings: Mapping[str, str]) -> Iterator[str]:
    first, *others = document.sections
    yield f"<h1>{escape(document.title)}</h1>"
    yield f'<p class="lead">{escape(document.lead)}</p>'
    yield from _section(first, drawings)
    yield f"<nav><ol>\n{_links((_id(s.title), s.title) for s in others)}\n</ol>"
    listed = _links(titles_in(document))
    yield f"<details><summary>Tables and figures</summary><ul>\n{listed}\n</ul></details></nav>"
    for section in others:
        yield from _section(section, drawings)


def _links(targets: Iterable[tuple[str, str]]) -> str:
    return "\n".join(f'<li><a href="#{target}">{escape(text)}</a></li>' for target, text in targets)


def _section(section: Section, drawings: Mapping[str, str]) -> Iterator[str]:
    yield f'<section id="{_id(section.title)}">'
    yield f"<h2>{escape(section.title)}</h2>"
    if section.folded:
        yield f"<details><summary>{escape(section.folded)}</summary>"
    for block in section.blocks:
        yield from _html(block, drawings)
    yield "</details></section>" if section.folded else "</section>"


def _html(block: Block, drawings: Mapping[str, str]) -> Iterator[str]:
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
        case References(items):
            yield "<ol>" + "\n".join(f"<li>{escape(item.text)}{_doi(item)}</li>" for item in items) + "</ol>"
        case Figure(name, title, caption):
            svg = drawings[name]
            yield f'<figure id="{name}">{svg[svg.index("<svg") :]}'
            yield f"<figcaption><b>{escape(title)}.</b> {escape(caption)}</figcaption></figure>"


def _doi(source: Source) -> str:
    return f' <a href="https://doi.org/{source.doi}">doi:{source.doi}</a>' if source.doi else ""


def _coloured(html: str) -> str:
    """Mark verdicts, numbers and rows of averages for the style."""
    for text, name in _CLASSES.items():
        effect = r"(?: -?[\d.]+(?: \[.*?\])?(?: \(.*?\))?)?(?: \*)?"
        html = re.sub(f"<td>({text}{effect})</td>", rf'<td class="{name}">\1</td>', html)
    html = re.sub(r"<tr><td>Average result", '<tr class="average"><td>Average result', html)
    number = r"(?:&lt; )?-?[\d.]+%?(?: \[[^]]*\])?(?: / \d+ / \d+|/\d+)?|\[[^]]*\]"
    return re.sub(f"<td>({number})</td>", r'<td class="number">\1</td>', html)


def _id(title: str) -> str:
    return re.sub(r"\W+", "-", title.lower()).strip("-")


def as_csv(table: Table) -> str:
    """Return a table with its headings as CSV."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([table.headings, *table.rows])
    return text.getvalue()
