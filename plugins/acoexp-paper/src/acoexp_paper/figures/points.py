"""The feature points of a convergence curve (Fig. 15)."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import StrMethodFormatter

from acoexp.compare.sample import Sample
from acoexp_paper.figures.drawing import COLOURS, WIDTH, new_figure

_OFFSETS = {"A": (-4, -16), "B": (4, -16), "C": (4, 8)}
"""Of their names, so that those of A and B do not meet."""


def telling_trial(sample: Sample) -> int:
    """Return the trial in which A, B and C lie farthest apart, on two heights if there is one."""
    x = sample.features
    apart = np.minimum(x["x2"] / x["x1"], x["x3"] / x["x2"]) + 1e3 * (x["l1"] < x["l2"])
    return int(np.argmax(np.nan_to_num(apart)))


def draw_points(sample: Sample, trial: int) -> Figure:
    """Draw the curve of a trial with A(x1, l1), B(x2, l1) and C(x3, l2)."""
    figure = new_figure(2.6, WIDTH * 0.75)
    axes = figure.subplots()
    axes.plot(np.arange(1, sample.iterations + 1), sample.curves[trial], color=COLOURS["aco"])
    axes.axhline(sample.optimum, color="black", linewidth=0.8, linestyle=":")
    values = {name: feature[trial] for name, feature in sample.features.items()}
    for point, cycle, length in (("A", "x1", "l1"), ("B", "x2", "l1"), ("C", "x3", "l2")):
        where = values[cycle], values[length]
        axes.plot(*where, "o", color="black", markersize=5)
        axes.annotate(
            f"{point}({cycle}, {length})", where, _OFFSETS[point], textcoords="offset points", fontsize=8,
            ha="right" if point == "A" else "left",
        )  # fmt: skip
    axes.set(xscale="log", xlabel="cycle (log scale)", ylabel="best length in the cycle (cells)")
    axes.margins(y=0.2)
    axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    return figure
