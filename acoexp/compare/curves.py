"""Convergence curves of configurations: the median over trials, with quartiles, one panel per map."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from acoexp.compare.drawing import PLAIN, add_legend, bare, look, save
from acoexp.compare.sample import Sample
from acoexp.report.labels import as_it_is


def draw_curves(samples: Sequence[Sample], folder: Path) -> None:
    """Write ``curves.svg`` and ``curves.png``, the same bytes for the same trials."""
    maps = list(dict.fromkeys(sample.map for sample in samples))
    figure = Figure(figsize=(7, 0.6 + 3.6 * len(maps)), layout="constrained")
    panels = figure.subplots(len(maps), squeeze=False)[:, 0]
    for name, axes in zip(maps, panels, strict=True):
        _draw(axes, [sample for sample in samples if sample.map == name])
    labels = [sample.configuration for sample in samples if sample.map == maps[0]]
    add_legend(figure, panels[0].get_lines(), [*labels, "exact optimum"], "median and quartiles over trials")
    save(figure, folder, "curves")


def _draw(axes: Axes, samples: Sequence[Sample]) -> None:
    optimum = samples[0].optimum
    for place, sample in enumerate(samples):
        lower, median, upper = quartiles(sample)
        cycles = np.arange(1, sample.iterations + 1)
        axes.fill_between(cycles, lower, upper, color=look(place)["color"], alpha=0.15, linewidth=0)
        axes.plot(cycles, median, **look(place))
    axes.axhline(optimum, color="0.4", linewidth=0.8)
    last = max(sample.iterations for sample in samples)
    axes.set(title=f"{as_it_is(samples[0].map)}, optimum {optimum:.4f}", xscale="log", xlim=(0.95, 1.05 * last))
    axes.set(xlabel="cycle (log scale)", ylabel="best path length in the cycle (cells)")
    axes.xaxis.set_major_formatter(PLAIN)
    bare(axes)


def quartiles(sample: Sample) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Return quartile, median and quartile over trials, float[3, iterations].

    A trial whose ants were all lost in a cycle ranks behind all others; nan where one of them is met.
    """
    ranked = np.nan_to_num(sample.curves, nan=np.inf)
    points = np.quantile(ranked, (0.25, 0.5, 0.75), axis=0, method="inverted_cdf")
    return np.where(np.isinf(points), np.nan, points)
