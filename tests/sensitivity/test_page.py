"""The page: the verdict first, names as they are, no other file needed."""

from __future__ import annotations

import re

import numpy as np

from acoexp.report.render import as_csv
from acoexp.sensitivity.page import Part, as_html, as_markdown, headline_rows, parts_of
from acoexp.sensitivity.rows import share_rows
from acoexp.sensitivity.shares import Share, Shares
from acoexp.sensitivity.span import Factor, Span

FACTORS = [Factor("rho", Span(0.1, 0.9), 0.5), Factor("max_steps", Span(5.0, 9.0, whole=True), float("nan"))]
KEYS = [factor.key for factor in FACTORS]
ONE = Shares(
    [Share(0.3, 0.2, 0.4), Share(0.0, 0.0, 0.0)],
    [Share(0.5, 0.4, 0.6), Share(0.1, 0.0, 0.2)],
    Share(0.2, 0.1, 0.3),
    Share(0.5, 0.4, 0.6),
    np.array([0.97, 0.03]),
)
SHARES = {"gap": ONE, "lost": None}


def tables() -> dict[str, list[list[str]]]:
    """Return the rows of each table by its title."""
    return {part.table.title: part.table.rows for part in parts_of(FACTORS, SHARES) if part.table is not None}


def test_its_tables_say_who_leads_by_how_much_and_what_was_looked_at() -> None:
    assert tables()["Leaders"] == [
        ["gap of the best length to the optimum (%)", "rho", "50 % [40, 60]", "97 %", "50 % [40, 60]"],
        ["ants that were lost (%)", "the same in all trials", "-", "-", "-"],
    ]
    assert tables()["Shares"] == [
        ["rho", "30 % [20, 40] / 50 % [40, 60]"],
        ["max_steps", "0 % [0, 0] / 10 % [0, 20]"],
        ["several keys together", "20 % [10, 30]"],
        ["seeds", "50 % [40, 60]"],
    ]
    assert tables()["Spans"] == [["rho", "0.1 to 0.9", "0.5"], ["max_steps", "5 to 9", "null"]]


def test_the_page_begins_with_the_verdict_and_needs_no_other_file() -> None:
    parts = [Part("Shares", "what they are", None, "x.svg")]
    page = as_html("on <b>", ["a < b", "second"], parts, {"x.svg": '<?xml version="1.0"?><svg><g/></svg>'})
    assert "<h1>on &lt;b&gt;</h1>\n<p><strong>a &lt; b</strong></p>\n<p>second</p>" in page
    assert "<svg><g/></svg>" in page
    assert not re.search(r"<\?xml|<(img|link|script|iframe)\b|@import|url\(", page)


def test_markdown_leads_to_the_pictures() -> None:
    page = as_markdown("on *x*", ["lead"], [Part("Shares", "what they are", None, "x.svg")])
    assert page == "# on \\*x\\*\n\nlead\n\n## Shares\n\nwhat they are\n\n![Shares](x.svg)\n"


def test_the_terminal_shows_each_keys_share_with_what_it_does_together_with_others() -> None:
    lines = as_csv(share_rows(KEYS, SHARES)).splitlines()
    rows = [dict(zip(lines[0].split(","), line.split(","), strict=True)) for line in lines[1:]]
    assert headline_rows(rows) == [
        ["share of the variance", "gap", "lost"],
        ["rho", "50 % [40, 60]", "-"],
        ["max_steps", "10 % [0, 20]", "-"],
        ["several keys together", "20 % [10, 30]", "-"],
        ["seeds", "50 % [40, 60]", "-"],
    ]
