"""The pictures: what explains the variance of each outcome, and each outcome along each key."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

from acoexp.report.palette import BLUE, GREEN, ORANGE
from acoexp.sensitivity.outcomes import OUTCOMES
from acoexp.sensitivity.rows import SEEDS, TOGETHER, Row
from acoexp.sensitivity.span import Factor

_GREY = "0.35"
_ALONE, _TOTAL = "a key alone", "a key and what it does together with others"
_TITLES = {
    "gap": "gap to the optimum",
    "cycles": "cycles until found",
    "found": "optimum found",
    "lost": "ants lost",
}


def draw_shares(rows: Sequence[Row], order: Sequence[str], folder: Path) -> None:
    """Write ``shares.svg``: a panel for each outcome, a line for each key in this order, seeds at the end."""
    sources = [*order, TOGETHER, SEEDS]
    figure = Figure(figsize=(10.5, 1.5 + 0.34 * len(sources)), layout="constrained")
    panels = figure.subplots(1, len(OUTCOMES), sharey=True, squeeze=False)[0]
    for axes, outcome in zip(panels, OUTCOMES, strict=True):
        _draw_shares(axes, [row for row in rows if row["outcome"] == outcome], sources)
        axes.set_title(_TITLES[outcome], fontsize=10.5)
    panels[0].set_yticks(range(len(sources)), sources)
    panels[0].set_ylim(len(sources) - 0.4, -0.6)
    figure.supxlabel("share of the variance of one trial (%), with 95 % intervals", fontsize=10)
    drawn = {line.get_label(): line for axes in panels for line in axes.get_lines()}
    named = [label for label in (_ALONE, _TOTAL, TOGETHER, SEEDS) if label in drawn]
    figure.legend(
        [drawn[n] for n in named], named, loc="outside upper center", ncols=4, frameon=False, fontsize=9.5
    )
    _save(figure, folder / "shares.svg")


def _draw_shares(axes: Axes, rows: Sequence[Row], sources: Sequence[str]) -> None:
    axes.axvline(0.0, color="0.6", linewidth=0.8)
    axes.axhline(len(sources) - 2.5, color="0.8", linewidth=0.8)
    axes.set_xlim(-15, 115)
    axes.set_xticks([0, 25, 50, 75, 100])
    axes.grid(axis="x", color="0.9", linewidth=0.8)
    axes.set_axisbelow(True)
    axes.tick_params(axis="y", length=0)
    axes.spines[["top", "right", "left"]].set_visible(False)
    if all(np.isnan(row["alone"]) for row in rows):
        axes.text(46, (len(sources) - 1) / 2, "the same in all trials", ha="center", va="center", color=_GREY)
        return
    for row in rows:
        place = sources.index(row["source"])
        if row["source"] in (TOGETHER, SEEDS):
            mark, colour = ("D", GREEN) if row["source"] == TOGETHER else ("s", "black")
            _draw_share(axes, row, "alone", place, mark, colour, row["source"])
        else:
            _draw_share(axes, row, "alone", place - 0.13, "o", BLUE, _ALONE)
            _draw_share(axes, row, "total", place + 0.17, "^", ORANGE, _TOTAL)


def _draw_share(axes: Axes, row: Row, name: str, place: float, mark: str, colour: str, label: str) -> None:
    low, value, high = (100.0 * row[key] for key in (f"{name}_low", name, f"{name}_high"))
    axes.plot([low, high], [place, place], color=colour, linewidth=1.6, alpha=0.6, solid_capstyle="butt")
    axes.plot([value], [place], mark, color=colour, markersize=5.5, label=label)


def draw_curves(rows: Sequence[Row], factors: Sequence[Factor], folder: Path) -> None:
    """Write ``curves.svg``: a row for each key, a panel for each outcome, with the command line's value marked."""
    figure = Figure(figsize=(10.5, 0.5 + 1.75 * len(factors)), layout="constrained")
    panels = figure.subplots(len(factors), len(OUTCOMES), sharex="row", sharey="col", squeeze=False)
    for factor, row in zip(factors, panels, strict=True):
        along = [one for one in rows if one["key"] == factor.key]
        for axes, outcome in zip(row, OUTCOMES, strict=True):
            _draw_curve(axes, along, outcome, factor)
        row[0].set_ylabel(factor.key.replace(".", ".\n"), fontsize=11, fontweight="bold")
    for axes, outcome in zip(panels[0], OUTCOMES, strict=True):
        axes.set_title(f"{_TITLES[outcome]}{'' if outcome == 'cycles' else ' (%)'}", fontsize=10.5)
        axes.set_ylim(bottom=0.0)
    _save(figure, folder / "curves.svg")


def _draw_curve(axes: Axes, along: Sequence[Row], outcome: str, factor: Factor) -> None:
    values = [row["value"] for row in along]
    low, mean, high = ([row[name] for row in along] for name in (f"{outcome}_low", outcome, f"{outcome}_high"))
    if not np.isnan(factor.value):
        axes.axvline(factor.value, color=_GREY, linewidth=1.0, linestyle=":")
    axes.fill_between(values, low, high, color=BLUE, alpha=0.2, linewidth=0)
    axes.plot(values, mean, "-o", color=BLUE, markersize=3, linewidth=1.4)
    axes.grid(color="0.92", linewidth=0.8)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.tick_params(labelsize=8.5)
    if factor.span.log:
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))


def _save(figure: Figure, file: Path) -> None:
    """Write a figure, the same bytes for the same numbers."""
    FigureCanvasAgg(figure)
    with rc_context({"svg.hashsalt": "acoexp"}):
        figure.savefig(file, metadata={"Date": None})
