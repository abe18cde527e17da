"""The document as HTML, Markdown and CSV."""

from __future__ import annotations

import pytest
from acoexp_paper.page.document import (
    Bullets,
    Document,
    Figure,
    Heading,
    Numbers,
    References,
    Section,
    Source,
    Text,
)
from acoexp_paper.page.render import as_csv, as_html, as_markdown

from acoexp.report.table import Table

TABLE = Table("Claims.", "a < b", ["claim", "verdict"], [["x, y", "holds"], ["z", "0.12 [0.10, 0.14]"]])
DOCUMENT = Document(
    "A & B",
    "lead",
    [
        Section("The claims", [Text("1 < 2"), Heading("more"), Numbers("claims", TABLE)]),
        Section(
            "Figures", [Bullets(["one", "two"]), Figure("fig01", "Fig. 1. Force", "a caption")], "all of them"
        ),
        Section("References", [References([Source("Holm S (1979)"), Source("Liu J (2017)", "10.1/x")])]),
    ],
)


def test_markdown_has_every_block_in_its_order() -> None:
    assert as_markdown(DOCUMENT).split("\n\n") == [
        "# A & B",
        "lead",
        "## The claims",
        "1 < 2",
        "### more",
        "**Claims.**",
        "a < b",
        "| claim | verdict |\n| --- | --- |\n| x, y | holds |\n| z | 0.12 [0.10, 0.14] |",
        "## Figures",
        "- one\n- two",
        "![Fig. 1. Force](figures/fig01.svg)",
        "**Fig. 1. Force.** a caption",
        "## References",
        "1. Holm S (1979)\n2. Liu J (2017) [doi:10.1/x](https://doi.org/10.1/x)\n",
    ]


@pytest.mark.parametrize(
    "part",
    [
        "<title>A &amp; B</title>",
        '</section>\n<nav><ol>\n<li><a href="#figures">Figures</a></li>\n<li><a href="#references">',
        '<ul>\n<li><a href="#claims">Claims</a></li>\n<li><a href="#fig01">Fig. 1. Force</a></li>\n</ul>',
        '<section id="figures">\n<h2>Figures</h2>\n<details><summary>all of them</summary>',
        '<li>Liu J (2017) <a href="https://doi.org/10.1/x">doi:10.1/x</a></li></ol>',
        '<section id="the-claims">\n<h2>The claims</h2>\n<p>1 &lt; 2</p>\n<h3>more</h3>',
        '<figure class="table" id="claims">\n<figcaption><b>Claims.</b> a &lt; b</figcaption>',
        "<ul><li>one</li>\n<li>two</li></ul>",
        '<figure id="fig01"><svg>drawn</svg>\n<figcaption><b>Fig. 1. Force.</b> a caption</figcaption></figure>',
    ],
)
def test_the_page_has_every_block_with_the_figures_within(part: str) -> None:
    assert part in as_html(DOCUMENT, {"fig01": "<?xml?><svg>drawn</svg>"})


def test_the_page_brings_its_style() -> None:
    assert "<style>\nbody {" in as_html(DOCUMENT, {"fig01": "<svg/>"})


@pytest.mark.parametrize(
    ("text", "style"),
    [
        ("shown", "yes"),
        ("shown 0.90 (0.70)", "yes"),
        ("undecided -0.10 (-)", "no"),
        ("undecided", "no"),
        ("contradicted", "against"),
        ("depends on the map", "mixed"),
        ("0.12 [0.10, 0.14]", "number"),
        ("&lt; 0.001", "number"),
        ("3 / 0 / 1", "number"),
        ("4/5", "number"),
    ],
)
def test_verdicts_and_numbers_are_marked_for_the_style(text: str, style: str) -> None:
    table = Table("", "", ["a", "b"], [["words", text.replace("&lt;", "<")], ["Average result", ""]])
    html = as_html(Document("", "", [Section("", [Numbers("t", table)])]), {})
    assert f'<tr><td>words</td><td class="{style}">{text}</td></tr>' in html
    assert '<tr class="average"><td>Average result</td>' in html


def test_csv_is_the_table_alone() -> None:
    assert as_csv(TABLE) == 'claim,verdict\n"x, y",holds\nz,"0.12 [0.10, 0.14]"\n'
