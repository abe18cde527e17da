"""The document: sections of paragraphs, headings, lists, references, tables and figures, which are numbered."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from string import ascii_uppercase
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


class Source(NamedTuple):
    """What is cited, and its DOI, if it has one."""

    text: str
    doi: str | None = None


class References(NamedTuple):
    """A list of what is cited."""

    items: Sequence[Source]


class Numbers(NamedTuple):
    """A table, and the name of its files."""

    name: str
    table: Table


class Figure(NamedTuple):
    """A figure, by the name of its files: what it is called, and what it shows."""

    name: str
    title: str
    caption: str


Block = Text | Heading | Bullets | References | Numbers | Figure


class Section(NamedTuple):
    """A section; one that is folded shows what it is about, and the rest when it is asked for."""

    title: str
    blocks: Sequence[Block]
    folded: str = ""


class Document(NamedTuple):
    """The whole."""

    title: str
    lead: str
    sections: Sequence[Section]


def numbered(document: Document) -> Document:
    """Return a document whose tables and figures are numbered.

    Those of the paper, whose titles begin with "Table" or "Fig.", keep their numbers; ours get letters, in the
    order in which they stand.
    """
    letters = {"Table": iter(ascii_uppercase), "Fig.": iter(ascii_uppercase)}

    def label(kind: str, title: str) -> str:
        return title if title.startswith(f"{kind} ") else f"{kind} {next(letters[kind])}. {title}"

    def block(given: Block) -> Block:
        match given:
            case Numbers(name, table):
                return Numbers(name, table._replace(title=label("Table", table.title)))
            case Figure(name, title, caption):
                return Figure(name, label("Fig.", title), caption)
        return given

    return document._replace(
        sections=[section._replace(blocks=[block(one) for one in section.blocks]) for section in document.sections]
    )


def titles_in(document: Document) -> Iterator[tuple[str, str]]:
    """Yield the name and the title of each table and figure, in their order."""
    for section in document.sections:
        for block in section.blocks:
            if isinstance(block, Numbers):
                yield block.name, block.table.title.removesuffix(".")
            elif isinstance(block, Figure):
                yield block.name, block.title


def tables_in(document: Document) -> dict[str, Table]:
    """Return all tables by name."""
    blocks = (block for section in document.sections for block in section.blocks)
    return {block.name: block.table for block in blocks if isinstance(block, Numbers)}
