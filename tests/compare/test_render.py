"""Tables as texts: what has a meaning in a format is written so that it has none."""

from __future__ import annotations

from html.parser import HTMLParser

import pytest
from markdown_it import MarkdownIt

from acoexp.compare.render import as_html, as_latex, as_markdown
from acoexp.report.table import Table

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


def test_a_page_in_markdown_leads_to_its_picture() -> None:
    page = as_markdown("T", "lead", [TABLE], "x.svg")
    assert page.startswith("# T\n\nlead\n\n## Odd\n\n5 % & more\n\n")
    assert page.endswith("(x.svg)\n")


NAMES = [
    "a|b", "`a`", "**a**", "_a_", "a_b", "~~a~~", "[a](http://b)", "![a](b)", "<script>alert(1)</script>", "<b>",
    "a<b", "&lt;", "a & b", "a\\", "\\|", "\\`|", "$x$", "# a", "- a", "1. a", "=1+1", "a--b", "[b]x", "*x", "%",
    "{",
]  # fmt: skip
"""Names of maps and configurations as people have them."""


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_read_as_it_is_on_the_page(name: str) -> None:
    page = as_html("T", name, [Table("t", "n", ["map"], [[name]])], "<svg/>")
    assert texts_of(page).count(name) == 2
    assert "<script" not in page


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_read_as_it_is_in_markdown(name: str) -> None:
    page = as_markdown("T", f"on {name}", [Table("t", "n", ["map", "p"], [[name, "1"]])], "x.svg")
    html = MarkdownIt("commonmark", {"html": True}).enable(["table", "strikethrough"]).render(page)
    assert {f"on {name}", name, "1"} <= set(texts_of(html))


def texts_of(html: str) -> list[str]:
    """Return the texts between a page's tags."""
    found: list[str] = []
    parser = HTMLParser()
    parser.handle_data = found.append  # type: ignore[method-assign]
    parser.feed(html)
    return found


@pytest.mark.parametrize(
    ("name", "row"),
    [
        ("[b]x", "{}[b]x & 1 \\\\"),  # else the length of the space before it
        ("*x", "{}*x & 1 \\\\"),
        ("a--b", "a-{}-b & 1 \\\\"),  # else one long dash
        ("a\nb", "a b & 1 \\\\"),
        ("\\~^&%$#_{}", "\\textbackslash{}\\textasciitilde{}\\textasciicircum{}\\&\\%\\$\\#\\_\\{\\} & 1 \\\\"),
    ],
)
def test_a_name_is_set_as_it_is_in_latex(name: str, row: str) -> None:
    assert row in as_latex([Table("t", "n", ["map", "p"], [[name, "1"]])]).splitlines()
