"""The report's page: what it says first, then sections of tables and pictures, as HTML and as Markdown."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import NamedTuple

from acoexp.report.render import html_page, html_table, markdown_table, markdown_text
from acoexp.report.table import Table


class Picture(NamedTuple):
    """A picture: its title, what it shows, and the name of its files without an ending."""

    title: str
    note: str
    name: str


class Section(NamedTuple):
    """A part of the page.

    Attributes:
        title: Its title.
        blocks: What is in it.
        folded: By title, the tables that have too many rows to be read, each with the file that has them all: they
            are folded on the page, and elsewhere only the file is named.
    """

    title: str
    blocks: Sequence[Table | Picture]
    folded: Mapping[str, str] = {}


class Page(NamedTuple):
    """All of it: title, what was compared, the verdict, and the sections."""

    title: str
    lead: str
    verdict: str
    sections: Sequence[Section]

    @property
    def tables(self) -> list[Table]:
        """The tables that can be read whole."""
        return [
            block
            for section in self.sections
            for block in section.blocks
            if isinstance(block, Table) and block.title not in section.folded
        ]

    @property
    def pictures(self) -> list[Picture]:
        """The pictures."""
        return [block for section in self.sections for block in section.blocks if isinstance(block, Picture)]


def as_markdown(page: Page) -> str:
    """Return the page with links to its pictures."""
    parts = [f"# {markdown_text(page.title)}", markdown_text(page.lead), f"> {markdown_text(page.verdict)}"]
    for section in page.sections:
        parts.append(f"## {markdown_text(section.title)}")
        for block in section.blocks:
            parts += [f"### {markdown_text(block.title)}", markdown_text(block.note)]
            if isinstance(block, Picture):
                parts.append(f"![{markdown_text(block.title)}]({block.name}.svg)")
            elif block.title in section.folded:
                parts.append(f"`{section.folded[block.title]}` has its {len(block.rows)} rows.")
            else:
                parts.append(markdown_table(block))
    return "\n\n".join(parts) + "\n"


def as_html(page: Page, svgs: Mapping[str, str]) -> str:
    """Return the page as one file that needs no other.

    Args:
        page: The page.
        svgs: The text of each picture's SVG, by its name.
    """
    links = "".join(f'<a href="#part-{n}">{escape(one.title)}</a>' for n, one in enumerate(page.sections))
    body = [f"<h1>{escape(page.title)}</h1>", f"<p>{escape(page.lead)}</p>"]
    body += [f'<p class="verdict">{escape(page.verdict)}</p>', f"<nav>{links}</nav>"]
    for number, section in enumerate(page.sections):
        body.append(f'<h2 id="part-{number}">{escape(section.title)}</h2>')
        for block in section.blocks:
            body += _picture(block, svgs) if isinstance(block, Picture) else _table(block, section.folded)
    return html_page(page.title, body)


def _picture(picture: Picture, svgs: Mapping[str, str]) -> list[str]:
    svg = svgs[picture.name]
    caption = f"<figcaption>{escape(picture.note)}</figcaption>"
    return [f"<h3>{escape(picture.title)}</h3>", f"<figure>{svg[svg.index('<svg') :]}{caption}</figure>"]


def _table(table: Table, folded: Mapping[str, str]) -> list[str]:
    note = f'<p class="note">{escape(table.note)}</p>'
    if table.title not in folded:
        return [f"<h3>{escape(table.title)}</h3>", note, html_table(table)]
    said = f"{escape(table.title)}: {len(table.rows)} rows, also in {folded[table.title]}"
    return [f"<details><summary>{said}</summary>", note, html_table(table), "</details>"]
