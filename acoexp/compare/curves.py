"""Convergence curves of configurations: the median over trials, with quartiles, one panel per map."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import StrMethodFormatter

from acoexp.compare.measures import Sample
from acoexp.report.labels import any_signs, as_it_is
from acoexp.report.palette import DASHES, SERIES


def draw_curves(samples: Sequence[Sample], folder: Path) -> None:
    """Write ``curves.svg`` and ``curves.png``, the same bytes for the same trials."""
    maps = list(dict.fromkeys(sample.map for sample in samples))
    figure = Figure(figsize=(7, 0.6 + 3.6 * len(maps)), layout="constrained")
    panels = figure.subplots(len(maps), squeeze=False)[:, 0]
    for name, axes in zip(maps, panels, strict=True):
        _draw(axes, [sample for sample in samples if sample.map == name])
    _add_legend(
        figure, panels[0].get_lines(), [sample.configuration for sample in samples if sample.map == maps[0]]
    )
    FigureCanvasAgg(figure)
    with any_signs():
        with rc_context({"svg.hashsalt": "acoexp"}):
            figure.savefig(folder / "curves.svg", metadata={"Date": None})
        figure.savefig(folder / "curves.png", dpi=150)


def _add_legend(figure: Figure, lines: Sequence[Line2D], configurations: Sequence[str]) -> None:
    """Name the curves; by texts that are set later, as a legend leaves out what begins with ``_``."""
    title, labels = "median and quartiles over trials", [*map(as_it_is, configurations), "exact optimum"]
    blanks = [" "] * len(labels)
    legend = figure.legend(lines, blanks, title=title, loc="outside lower center", ncols=2, frameon=False)
    for text, label in zip(legend.get_texts(), labels, strict=True):
        text.set_text(label)


def _draw(axes: Axes, samples: Sequence[Sample]) -> None:
    optimum = samples[0].optimum
    for place, sample in enumerate(samples):
        lower, median, upper = quartiles(sample)
        cycles = np.arange(1, sample.iterations + 1)
        colour = SERIES[place % len(SERIES)]
        axes.fill_between(cycles, lower, upper, color=colour, alpha=0.15, linewidth=0)
        axes.plot(cycles, median, DASHES[place % len(DASHES)], color=colour)
    axes.axhline(optimum, color="0.4", linewidth=0.8)
    axes.set(title=f"{as_it_is(samples[0].map)}, optimum {optimum:.4f}", xscale="log")
    axes.set(xlabel="cycle (log scale)", ylabel="best path length in the cycle (cells)")
    axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))


def quartiles(sample: Sample) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Return quartile, median and quartile over trials, float[3, iterations].

    A trial whose ants were all lost in a cycle ranks behind all others; nan where one of them is met.
    """
    ranked = np.nan_to_num(sample.curves, nan=np.inf)
    points = np.quantile(ranked, (0.25, 0.5, 0.75), axis=0, method="inverted_cdf")
    return np.where(np.isinf(points), np.nan, points)
