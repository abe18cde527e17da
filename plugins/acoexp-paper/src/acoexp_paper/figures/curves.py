"""Convergence curves (Figs 16 and 18): ten trials, the median of all, and what is printed of the paper's ten."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import StrMethodFormatter

from acoexp.compare.curves import quartiles
from acoexp.compare.sample import Sample
from acoexp_paper.figures.drawing import COLOURS, new_figure
from acoexp_paper.published.tables import ALGOS, TITLES, TRIALS, mended
from acoexp_paper.trials.samples import Samples

_WELL_ABOVE = 1.2
"""Of the optimum: so high the axis goes at least."""


def draw_curves(samples: Samples, table: int) -> Figure:
    """Draw a panel for each of ACO, ACO-PD and ACO-PDG.

    Args:
        samples: Our trials.
        table: The table with the paper's: where each of them found its best length and where it settled.
    """
    figure = new_figure(3.3)
    panels = figure.subplots(1, 3, sharey=True)
    for letter, axes, algo in zip("abc", panels, ALGOS, strict=True):
        _draw_ours(axes, samples[algo], COLOURS[algo])
        axes.set_title(f"{letter}. {TITLES[algo]}", fontsize=9)
        axes.set(xscale="log", xlabel="cycle (log scale)", xlim=(1, samples[algo].iterations))
        axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    top = max(panels[0].get_ylim()[1], _WELL_ABOVE * samples["aco"].optimum)
    for axes, algo in zip(panels, ALGOS, strict=True):
        _draw_published(axes, table, algo, top)
    panels[0].set(ylabel="best length in the cycle (cells)", ylim=panels[0].get_ylim())
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=5, fontsize=7, frameon=False)
    return figure


def _draw_ours(axes: Axes, sample: Sample, colour: str) -> None:
    cycles = np.arange(1, sample.iterations + 1)
    for trial, curve in enumerate(sample.curves[:TRIALS]):
        axes.plot(cycles, curve, color="0.62", linewidth=0.6, label="seeds 0 to 9" if trial == 0 else None)
    lower, median, upper = quartiles(sample)
    axes.fill_between(cycles, lower, upper, color=colour, alpha=0.25, linewidth=0)
    axes.plot(cycles, median, color=colour, linewidth=1.8, label="median, quartiles of all")
    axes.axhline(sample.optimum, color="black", linewidth=0.8, linestyle=":", label="optimum")


def _draw_published(axes: Axes, table: int, algo: str, top: float) -> None:
    """Draw the ten published trials; a length far above all of ours stands at the top, with its number."""
    for cycle, length, mark, label in (
        ("x1", "l1", "^", "published x1, l1"),
        ("x3", "l2", "s", "published x3, l2"),
    ):
        cycles, lengths = mended(table, algo, cycle), mended(table, algo, length)
        axes.plot(
            cycles, np.minimum(lengths, top), mark, color="black", markersize=4, markerfacecolor="none",
            markeredgewidth=0.8, label=label, zorder=4, clip_on=False,
        )  # fmt: skip
        for x, high in zip(cycles[lengths > top], lengths[lengths > top], strict=True):
            axes.annotate(f"{high:.4f}", (x, top), (6, -9), textcoords="offset points", fontsize=7)
