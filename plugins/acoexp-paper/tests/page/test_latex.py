"""Tables as LaTeX: how wide columns are, and when a page is turned."""

from __future__ import annotations

import re

import pytest
from acoexp_paper.page.latex import as_document, as_latex

from acoexp.report.table import Table

SENTENCE = "a sentence of many short words that goes on and on until nobody reads it any more " * 2


def widths(latex: str) -> list[float]:
    return [float(width) for width in re.findall(r"p{([\d.]+)mm}", latex)]


def test_a_table_has_its_title_and_note_as_a_caption_and_its_headings_on_every_page() -> None:
    latex = as_latex(Table("Claims.", "a < b, 50 %", ["claim", "x_1"], [["one", "1"], ["two", "2"]]))
    assert r"\caption{\textbf{Claims.} a $<$ b, 50 \%} \\" in latex
    assert latex.count(r"\toprule claim & x\_1 \\ \midrule") == 2
    assert "one & 1 \\\\\ntwo & 2 \\\\" in latex


def test_averages_are_set_off() -> None:
    latex = as_latex(Table("", "", ["a", "b"], [["", "1"], ["Average result", "1.0"]]))
    assert r"\midrule Average result & 1.0 \\ \midrule" in latex


def test_a_narrow_table_takes_no_more_room_than_its_entries() -> None:
    latex = as_latex(Table("", "", ["a", "b"], [["one", "1"]]))
    assert sum(widths(latex)) < 20
    assert "landscape" not in latex


def test_a_long_column_is_broken_into_lines_and_short_ones_are_not() -> None:
    latex = as_latex(Table("", "", ["claim", "p"], [[SENTENCE, "0.001"]]))
    assert sum(widths(latex)) == pytest.approx(170 - 2.2, abs=0.2)
    assert widths(latex)[1] == pytest.approx(5 * 1.5)
    assert "landscape" not in latex


def test_a_page_is_turned_for_many_long_columns() -> None:
    latex = as_latex(Table("", "", ["a", "b", "c"], [[SENTENCE] * 3]))
    assert sum(widths(latex)) == pytest.approx(257 - 2 * 2.2, abs=0.2)
    assert latex.count("{landscape}") == 2


def test_the_document_takes_in_every_file_in_its_order() -> None:
    text = as_document(["one", "two"])
    assert "a4paper" in text
    assert text.index(r"\input{one}") < text.index(r"\input{two}") < text.index(r"\end{document}")
