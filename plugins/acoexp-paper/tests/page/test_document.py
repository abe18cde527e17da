"""The document's own questions."""

from __future__ import annotations

from acoexp_paper.page.document import Document, Heading, Numbers, Section, Text, tables_in

from acoexp.report.table import Table


def test_tables_are_found_in_all_sections_by_the_names_of_their_files() -> None:
    first, second = (Table(title, "", [], []) for title in ("first", "second"))
    sections = [
        Section("one", [Text("said"), Numbers("a", first)]),
        Section("two", [Heading("more"), Numbers("b", second)]),
    ]
    assert tables_in(Document("title", "lead", sections)) == {"a": first, "b": second}
