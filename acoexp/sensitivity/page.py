"""The report as a page, in HTML and in Markdown: the verdict, its numbers, the pictures, what was looked at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import NamedTuple

import numpy as np

from acoexp.report.render import html_page, html_table, markdown_table, markdown_text
from acoexp.report.table import Table
from acoexp.sensitivity.outcomes import OUTCOMES
from acoexp.sensitivity.shares import Share, Shares
from acoexp.sensitivity.span import Factor
from acoexp.sensitivity.verdict import leader, percent

_SHARES = (
    "Circles: what a key explains whatever the others are. Triangles: that, and what it explains together with "
    "others; where the two lie apart, keys act together. Below the line: all that only several keys together "
    "explain, and what no key explains, the chance of a trial's seed. Shares are estimates: those of keys that do "
    "nothing lie on either side of 0."
)
_CURVES = (
    "All other keys are as on the command line, whose own value is the dotted line. Means over trials, with 95 % "
    "intervals. What keys do together is not seen here."
)
_NUMBERS = (
    "Of the variance of one trial: what a key explains alone (first-order Sobol index) / and with what it does "
    "together with others (total index), each less what seeds add to it. All intervals are at 95 %, by a "
    "bootstrap over the points of the design."
)


class Part(NamedTuple):
    """A part of the page.

    Attributes:
        title: Its title.
        note: What it shows.
        table: Its table, or None.
        picture: Its picture's file, or None.
    """

    title: str
    note: str
    table: Table | None = None
    picture: str | None = None


def parts_of(factors: Sequence[Factor], shares: Mapping[str, Shares | None]) -> list[Part]:
    """Return what the page consists of, below its first sentences."""
    keys = [factor.key for factor in factors]
    return [
        Part("What explains the variance", _SHARES, leaders_table(keys, shares), "shares.svg"),
        Part("One key at a time", _CURVES, None, "curves.svg"),
        Part("Shares in numbers", _NUMBERS, shares_table(keys, shares)),
        Part("What was looked at", "", spans_table(factors)),
    ]


def leaders_table(keys: Sequence[str], shares: Mapping[str, Shares | None]) -> Table:
    """Return which key matters most for each outcome, with the bootstrap's say on it."""
    rows = []
    for outcome, found in shares.items():
        texts = ["the same in all trials", "-", "-", "-"]
        if found is not None:
            best = leader(found)
            sure = f"{100.0 * found.first[best]:.0f} %"
            texts = [keys[best], percent(found.total[best]), sure, percent(found.seeds)]
        rows.append([OUTCOMES[outcome], *texts])
    headings = ["outcome of a trial", "largest share", "of the variance", "largest in resamples", "seeds alone"]
    return Table("Leaders", "", headings, rows)


def shares_table(keys: Sequence[str], shares: Mapping[str, Shares | None]) -> Table:
    """Return all shares: of each key alone / with what it does together with others."""
    found = {outcome: one for outcome, one in shares.items() if one is not None}
    rows = [
        [key, *(f"{percent(one.alone[k])} / {percent(one.total[k])}" for one in found.values())]
        for k, key in enumerate(keys)
    ]
    rows += [["several keys together", *(percent(one.together) for one in found.values())]]
    rows += [["seeds", *(percent(one.seeds) for one in found.values())]]
    return Table("Shares", "", ["", *found], rows)


def spans_table(factors: Sequence[Factor]) -> Table:
    """Return what each key was varied over."""
    rows = [[f.key, str(f.span), "null" if np.isnan(f.value) else f"{f.value:g}"] for f in factors]
    return Table("Spans", "", ["key", "varied over", "command line"], rows)


def headline_rows(rows: Sequence[Mapping[str, str]]) -> list[list[str]]:
    """Return the terminal's table from the rows of ``shares.csv``: the share of each key, and of the seeds."""
    outcomes, sources = (list(dict.fromkeys(row[key] for row in rows)) for key in ("outcome", "source"))
    texts = {(row["outcome"], row["source"]): _short(row) for row in rows}
    headings = ["share of the variance", *outcomes]
    return [headings, *([source, *(texts[outcome, source] for outcome in outcomes)] for source in sources)]


def _short(row: Mapping[str, str]) -> str:
    name = "total" if row["total"] else "alone"
    numbers = [row[f"{name}{end}"] for end in ("", "_low", "_high")]
    return percent(Share(*map(float, numbers))) if all(numbers) else "-"


def as_markdown(title: str, lead: Sequence[str], parts: Sequence[Part]) -> str:
    """Return the page with links to its pictures."""
    blocks = [f"# {markdown_text(title)}", *map(markdown_text, lead)]
    for part in parts:
        blocks += [f"## {part.title}", *([part.note] if part.note else [])]
        blocks += [] if part.picture is None else [f"![{part.title}]({part.picture})"]
        blocks += [] if part.table is None else [markdown_table(part.table)]
    return "\n\n".join(blocks) + "\n"


def as_html(title: str, lead: Sequence[str], parts: Sequence[Part], pictures: Mapping[str, str]) -> str:
    """Return a page that needs no other file.

    Args:
        title: Its title.
        lead: Its first paragraphs, the first of which is the verdict.
        parts: What follows.
        pictures: The SVG text of each picture, by its file's name.
    """
    verdict, *others = map(escape, lead)
    body = [f"<h1>{escape(title)}</h1>", f"<p><strong>{verdict}</strong></p>", *(f"<p>{o}</p>" for o in others)]
    for part in parts:
        body += [f"<h2>{escape(part.title)}</h2>", *([f"<p>{escape(part.note)}</p>"] if part.note else [])]
        if part.picture is not None:
            svg = pictures[part.picture]
            body.append(svg[svg.index("<svg") :])
        if part.table is not None:
            body.append(html_table(part.table))
    return html_page(title, body)
