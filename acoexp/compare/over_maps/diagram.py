"""The critical-difference diagram (Demsar 2006): mean ranks on a scale, a bar over those not told apart."""

from __future__ import annotations

from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from acoexp.compare.drawing import look, save
from acoexp.compare.over_maps.ranking import cliques
from acoexp.compare.over_maps.verdict import Verdict
from acoexp.report.labels import as_it_is

_SCALE, _FIRST, _STEP = 0.0, -1.0, -0.62
"""Heights: of the scale, of the first name, and from one name to the next."""


def draw_diagram(verdict: Verdict, configurations: list[str], folder: Path) -> None:
    """Write ``ranks.svg`` and ``ranks.png``: the diagram of a verdict that has a critical difference."""
    assert verdict.difference is not None
    ranks, count = verdict.mean_ranks, len(configurations)
    groups = cliques(verdict.mean_ranks, verdict.difference) if verdict.differ else [ranks.argsort().tolist()]
    half = (count + 1) // 2
    bottom = _FIRST + _STEP * (half - 1) - 0.32 * len(groups) - 0.4
    figure = Figure(figsize=(8, 0.9 + 0.42 * (1.4 - bottom)), layout="constrained")
    axes = figure.subplots()
    axes.set_axis_off()
    width = max(count - 1.0, 1.0)
    axes.set(xlim=(1 - 0.45 * width, count + 0.45 * width), ylim=(bottom, 1.6))
    _draw_scale(axes, count)
    _draw_difference(axes, verdict.difference, count)
    for level, group in enumerate(groups):
        height = -0.3 - 0.3 * level
        axes.plot(ranks[[group[0], group[-1]]], [height] * 2, color="0.15", linewidth=4, solid_capstyle="round")
    first = _FIRST - 0.3 * (len(groups) - 1)
    for place, cell in enumerate(ranks.argsort(kind="stable").tolist()):
        left = place < half
        row = place if left else count - 1 - place
        _draw_name(axes, float(ranks[cell]), configurations[cell], cell, first + _STEP * row, left)
    save(figure, folder, "ranks")


def _draw_scale(axes: Axes, count: int) -> None:
    axes.plot([1, count], [_SCALE] * 2, color="0.15", linewidth=1.2)
    for rank in range(1, count + 1):
        axes.plot([rank] * 2, [_SCALE, _SCALE + 0.14], color="0.15", linewidth=1.2)
        axes.text(rank, _SCALE + 0.2, str(rank), ha="center", va="bottom", fontsize=10)
    axes.text((1 + count) / 2, 1.6, "mean rank over maps, 1 is the best", ha="center", va="top", fontsize=10)


def _draw_difference(axes: Axes, difference: float, count: int) -> None:
    """Draw how far apart is told apart, beside the scale's left end."""
    left, height = 1.0, 0.8
    right = min(left + difference, float(count))
    axes.plot([left, right], [height] * 2, color="0.15", linewidth=1.2)
    for end in (left, right):
        axes.plot([end] * 2, [height - 0.07, height + 0.07], color="0.15", linewidth=1.2)
    axes.text(right, height, f"  critical difference {difference:.2f}", va="center", fontsize=10)


def _draw_name(axes: Axes, rank: float, label: str, place: int, height: float, left: bool) -> None:
    """Lead from a rank on the scale to a name beside it."""
    low, high = axes.get_xlim()
    end = low + 0.28 * (high - low) * 0.8 if left else high - 0.28 * (high - low) * 0.8
    colour = look(place)["color"]
    axes.plot([rank, rank, end], [_SCALE, height, height], color=colour, linewidth=1.2)
    axes.plot([rank], [_SCALE], marker="o", markersize=5, color=colour, clip_on=False)
    text = f"{as_it_is(label)}  {rank:.2f}" if left else f"{rank:.2f}  {as_it_is(label)}"
    shift = -0.06 if left else 0.06
    axes.text(end + shift, height, text, ha="right" if left else "left", va="center", fontsize=10)
