"""The forest plot: the effect on each map with its interval, and what the maps say together."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from acoexp.compare.drawing import bare, look, save
from acoexp.compare.over_maps.pooling import Pooled, pooled
from acoexp.compare.over_maps.verdict import ENOUGH
from acoexp.compare.sample import Row
from acoexp.report.labels import as_it_is

_NAMED = 120
"""Maps up to which each has its name; of more only their intervals are drawn."""


def draw_forest(rows: Sequence[Row], configurations: Sequence[str], folder: Path) -> None:
    """Write ``effects.svg`` and ``effects.png``: a panel for each configuration against the first.

    Args:
        rows: Of :func:`~acoexp.compare.over_maps.pooling.effect_row`, those of one configuration side by side,
            each on the same maps.
        configurations: The labels; the first is what the others are held against.
        folder: Where the pictures go.
    """
    panels = [list(group) for _, group in groupby(rows, key=lambda row: row["a"])]
    maps = len(panels[0])
    order = np.argsort([sum(panel[place]["a12"] for panel in panels) for place in range(maps)], kind="stable")
    height = 0.17 * maps if maps <= _NAMED else 0.025 * min(maps, 600)
    figure = Figure(
        figsize=(2.4 + len(panels) * min(2.8, max(1.4, 9.0 / len(panels))), 1.6 + max(height, 0.8)),
        layout="constrained",
    )
    for axes, panel in zip(figure.subplots(1, len(panels), sharey=True, squeeze=False)[0], panels, strict=True):
        _draw(axes, [panel[place] for place in order], configurations)
    figure.supxlabel(
        "A12: probability that the path is shorter than with " + as_it_is(configurations[0]), fontsize=9
    )
    save(figure, folder, "effects")


def _draw(axes: Axes, rows: Sequence[Row], configurations: Sequence[str]) -> None:
    colour = look(configurations.index(rows[0]["a"]))["color"]
    heights = np.arange(len(rows)) + 2.0
    effects = np.array([row["a12"] for row in rows])
    thin = len(rows) > _NAMED
    axes.axvline(0.5, color="0.4", linewidth=0.8)
    axes.hlines(
        heights, [r["low"] for r in rows], [r["high"] for r in rows], color=colour, lw=0.5 if thin else 1.3
    )
    axes.plot(effects, heights, "s", color=colour, markersize=1.5 if thin else 3.5)
    if len(rows) >= ENOUGH:
        _draw_pooled(axes, pooled(effects))
    axes.set(xlim=(-0.03, 1.03), ylim=(-0.8, len(rows) + 2.2))
    axes.set_title(as_it_is(rows[0]["a"]), fontsize=10, color=colour)
    axes.set_xticks([0, 0.25, 0.5, 0.75, 1], ["0", ".25", ".5", ".75", "1"], fontsize=8)
    names = [] if thin else [as_it_is(row["map"]) for row in rows]
    ticks = [] if thin else heights.tolist()
    together = ([0.0], ["all maps"]) if len(rows) >= ENOUGH else ([], [])
    axes.set_yticks([*together[0], *ticks], [*together[1], *names], fontsize=7)
    bare(axes)
    axes.grid(visible=False, axis="y")


def _draw_pooled(axes: Axes, found: Pooled) -> None:
    """Draw the mean as a diamond as wide as its interval, on a line where the next map's effect may lie."""
    value, low, high = found.mean
    axes.hlines([0.0], found.next_low, found.next_high, color="0.45", linewidth=1.2, zorder=2)
    axes.fill([low, value, high, value], [0.0, 0.42, 0.0, -0.42], color="0.1", linewidth=0.8, zorder=3)
