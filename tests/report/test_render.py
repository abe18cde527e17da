"""Pages, tables and rows as texts: what has a meaning in a format is written so that it has none."""

from __future__ import annotations

import csv
import io
import json
import re

import pytest

from acoexp.report.render import as_csv, as_json, html_page, html_table, markdown_table, markdown_text
from acoexp.report.table import Table

TABLE = Table("Odd", "5 % & more", ["cell", "p"], [["a|b_c", "< 0.001"], ["1 ± 2", "∞"]])


def test_a_table_in_markdown() -> None:
    assert markdown_table(TABLE) == "| cell | p |\n| --- | --- |\n| a\\|b_c | < 0.001 |\n| 1 ± 2 | ∞ |"


def test_a_table_in_html() -> None:
    assert "<td>a|b_c</td><td>&lt; 0.001</td>" in html_table(TABLE)


def test_a_text_in_markdown_is_one_line_in_which_signs_stand_for_themselves() -> None:
    assert markdown_text("*a*\nb_c") == "\\*a\\* b_c"


def test_a_page_has_its_parts_in_order_and_needs_no_other_file() -> None:
    page = html_page("a & b", ["<p>one</p>", "<p>two</p>"])
    assert "<title>a &amp; b</title>" in page
    assert page.index("<p>one</p>") < page.index("<p>two</p>")
    assert not re.search(r"<(img|link|script|iframe)\b|@import|url\(", page)


def test_rows_say_where_there_is_no_value() -> None:
    rows = [{"cell": "a,b", "x": float("nan"), "y": float("inf"), "z": 0.1}]
    assert as_csv(rows) == 'cell,x,y,z\n"a,b",,inf,0.1\n'
    assert json.loads(as_json(rows)) == [{"cell": "a,b", "x": None, "y": "inf", "z": 0.1}]


@pytest.mark.parametrize("name", ["a|b", "=1+1", "a,b", '"a"', "<b>", "a\\", "a\nb"])
def test_a_name_is_read_as_it_is_in_csv(name: str) -> None:
    assert list(csv.DictReader(io.StringIO(as_csv([{"map": name}])))) == [{"map": name}]
