"""Tables as texts: what has a meaning in a format is written so that it has none."""

from __future__ import annotations

import json

from acoexp.compare.render import as_csv, as_html, as_json, as_latex, as_markdown
from acoexp.compare.tables import Table

TABLE = Table("Odd", "5 % & more", ["cell", "p"], [["a|b_c", "< 0.001"], ["1 ± 2", "∞"]])


def test_markdown() -> None:
    assert "| a\\|b_c | < 0.001 |\n| 1 ± 2 | ∞ |" in as_markdown("T", "lead", [TABLE], "x.svg")


def test_html_is_escaped_and_holds_the_picture() -> None:
    page = as_html("T", "a & b", [TABLE], '<?xml version="1.0"?><!DOCTYPE svg><svg><g/></svg>')
    assert "<td>a|b_c</td><td>&lt; 0.001</td>" in page
    assert "<p>a &amp; b</p>" in page
    assert "<svg><g/></svg>" in page
    assert "<?xml" not in page


def test_latex() -> None:
    text = as_latex([TABLE])
    assert "a|b\\_c & $<$ 0.001 \\\\" in text
    assert "1 $\\pm$ 2 & $\\infty$ \\\\" in text
    assert text.index("\\toprule") < text.index("\\midrule") < text.index("\\bottomrule")


def test_rows_say_where_there_is_no_value() -> None:
    rows = [{"cell": "a,b", "x": float("nan"), "y": float("inf"), "z": 0.1}]
    assert as_csv(rows) == 'cell,x,y,z\n"a,b",,inf,0.1\n'
    assert json.loads(as_json(rows)) == [{"cell": "a,b", "x": None, "y": "inf", "z": 0.1}]


def test_a_page_in_markdown_leads_to_its_picture() -> None:
    page = as_markdown("T", "lead", [TABLE], "x.svg")
    assert page.startswith("# T\n\nlead\n\n## Odd\n\n5 % & more\n\n")
    assert page.endswith("(x.svg)\n")
