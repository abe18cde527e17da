"""Convergence curves (Figs 16 and 18): ten trials each, and the median of all."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import StrMethodFormatter

from acoexp.compare.curves import quartiles
from acoexp_paper.figures.drawing import COLOURS, new_figure
from acoexp_paper.published.tables import ALGOS, TITLES, TRIALS
from acoexp_paper.trials.samples import Samples


def draw_curves(samples: Samples) -> Figure:
    """Draw a panel for each of ACO, ACO-PD and ACO-PDG."""
    figure = new_figure(2.9)
    panels = figure.subplots(1, 3, sharey=True)
    for letter, axes, algo in zip("abc", panels, ALGOS, strict=True):
        sample = samples[algo]
        cycles = np.arange(1, sample.iterations + 1)
        for number, curve in enumerate(sample.curves[:TRIALS]):
            axes.plot(cycles, curve, color="0.62", linewidth=0.6, label="seeds 0 to 9" if number == 0 else None)
        lower, median, upper = quartiles(sample)
        axes.fill_between(cycles, lower, upper, color=COLOURS[algo], alpha=0.25, linewidth=0)
        axes.plot(cycles, median, color=COLOURS[algo], linewidth=1.8, label="median, quartiles of all")
        axes.axhline(sample.optimum, color="black", linewidth=0.8, linestyle=":", label="optimum")
        axes.set_title(f"{letter}. {TITLES[algo]}", fontsize=9)
        axes.set(xscale="log", xlabel="cycle (log scale)", xlim=(1, sample.iterations))
        axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axes.legend(fontsize=7, frameon=False)
    panels[0].set_ylabel("best length in the cycle (cells)")
    return figure
