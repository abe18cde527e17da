"""Tables as texts: what has a meaning in a format is written so that it has none."""

from __future__ import annotations

from html.parser import HTMLParser

import pytest
from markdown_it import MarkdownIt

from acoexp.compare.render import as_latex
from acoexp.report.render import html_table, markdown_table, markdown_text
from acoexp.report.table import Table

TABLE = Table("Odd", "5 % & more", ["cell", "p"], [["a|b_c", "< 0.001"], ["1 ± 2", "∞"]])


def test_markdown() -> None:
    assert markdown_table(TABLE).endswith("| a\\|b_c | < 0.001 |\n| 1 ± 2 | ∞ |")


def test_html_is_escaped() -> None:
    assert "<td>a|b_c</td><td>&lt; 0.001</td>" in html_table(TABLE)


def test_latex() -> None:
    text = as_latex([TABLE])
    assert "a|b\\_c & $<$ 0.001 \\\\" in text
    assert "1 $\\pm$ 2 & $\\infty$ \\\\" in text
    assert text.index("\\toprule") < text.index("\\midrule") < text.index("\\bottomrule")


NAMES = [
    "a|b", "`a`", "**a**", "_a_", "a_b", "~~a~~", "[a](http://b)", "![a](b)", "<script>alert(1)</script>", "<b>",
    "a<b", "&lt;", "a & b", "a\\", "\\|", "\\`|", "$x$", "# a", "- a", "1. a", "=1+1", "a--b", "[b]x", "*x", "%",
    "{",
]  # fmt: skip
"""Names of maps and configurations as people have them."""


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_read_as_it_is_in_html(name: str) -> None:
    html = html_table(Table("t", "n", ["map"], [[name]]))
    assert name in texts_of(html)
    assert "<script" not in html


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_read_as_it_is_in_markdown(name: str) -> None:
    page = f"{markdown_text(f'on {name}')}\n\n{markdown_table(Table('t', 'n', ['map', 'p'], [[name, '1']]))}\n"
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
