"""The page: all of it in one file, what is too long folded there, and named in Markdown."""

from __future__ import annotations

from acoexp.compare.page import Page, Picture, Section, as_html, as_markdown
from acoexp.report.table import Table

SHORT = Table("Short", "5 % & more", ["cell", "p"], [["a<b", "1"]])
LONG = Table("Long", "of each map", ["cell"], [["x"], ["y"], ["z"]])
PICTURE = Picture("Curve", "median & quartiles", "curve")
PAGE = Page("T", "on $x$", "a is better than <b>", [Section("Over maps", [SHORT, PICTURE]),
                                                    Section("On each", [LONG], {"Long": "long.csv"})])  # fmt: skip
SVGS = {"curve": '<?xml version="1.0"?><!DOCTYPE svg><svg><g/></svg>'}


def test_the_verdict_comes_before_everything_else() -> None:
    for text in (as_html(PAGE, SVGS), as_markdown(PAGE)):
        assert text.index("better than") < text.index("Over maps") < text.index("On each")


def test_html_is_escaped_and_holds_the_pictures() -> None:
    html = as_html(PAGE, SVGS)
    assert '<p class="verdict">a is better than &lt;b&gt;</p>' in html
    assert "5 % &amp; more" in html
    assert "<figure><svg><g/></svg><figcaption>median &amp; quartiles</figcaption></figure>" in html
    assert "<?xml" not in html


def test_each_section_is_linked_to() -> None:
    html = as_html(PAGE, SVGS)
    for number, title in enumerate(("Over maps", "On each")):
        assert f'<a href="#part-{number}">{title}</a>' in html
        assert f'<h2 id="part-{number}">{title}</h2>' in html


def test_what_is_too_long_is_folded_with_all_its_rows() -> None:
    folded = as_html(PAGE, SVGS).partition("<details><summary>Long: 3 rows, also in long.csv</summary>")[2]
    assert folded.partition("</details>")[0].count("<td>") == 3
    assert "<td>a&lt;b</td>" not in folded


def test_markdown_leads_to_pictures_and_to_the_file_of_what_is_too_long() -> None:
    text = as_markdown(PAGE)
    assert text.startswith(
        "# T\n\non \\$x\\$\n\n> a is better than \\<b>\n\n## Over maps\n\n### Short\n\n5 % & more\n\n"
    )
    assert "![Curve](curve.svg)" in text
    assert text.endswith("### Long\n\nof each map\n\n`long.csv` has its 3 rows.\n")


def test_what_can_be_read_whole_is_told_from_the_rest() -> None:
    assert PAGE.tables == [SHORT]
    assert PAGE.pictures == [PICTURE]
