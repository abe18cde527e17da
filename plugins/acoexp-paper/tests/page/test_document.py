"""The document's own questions."""

from __future__ import annotations

from acoexp_paper.page.document import (
    Document,
    Figure,
    Heading,
    Numbers,
    Section,
    Text,
    numbered,
    tables_in,
    titles_in,
)

from acoexp.report.table import Table


def table(title: str) -> Table:
    return Table(title, "", [], [])


def test_tables_are_found_in_all_sections_by_the_names_of_their_files() -> None:
    sections = [
        Section("one", [Text("said"), Numbers("a", table("first"))]),
        Section("two", [Heading("more"), Numbers("b", table("second"))]),
    ]
    found = {"a": table("first"), "b": table("second")}
    assert tables_in(Document("title", "lead", sections)) == found


def test_the_papers_tables_and_figures_keep_their_numbers_and_ours_get_letters() -> None:
    sections = [
        Section("one", [Numbers("claims", table("Claims.")), Numbers("table1", table("Table 1. Trials."))]),
        Section("two", [Text("said"), Figure("fig01", "Fig. 1. Force", ""), Figure("maps", "Maps", "")], "folded"),
        Section("three", [Numbers("fits", table("Fits."))]),
    ]
    given = Document("title", "lead", sections)
    assert list(titles_in(numbered(given))) == [
        ("claims", "Table A. Claims"),
        ("table1", "Table 1. Trials"),
        ("fig01", "Fig. 1. Force"),
        ("maps", "Fig. A. Maps"),
        ("fits", "Table B. Fits"),
    ]
    assert numbered(given).sections[1].folded == "folded"
