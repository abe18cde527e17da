"""The document: sections of paragraphs, headings, lists, tables and figures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from acoexp.report.table import Table


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
