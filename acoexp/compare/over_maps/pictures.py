"""Pictures of curves over maps: performance profiles, targets hit, and gaps that are left."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter, PercentFormatter

from acoexp.compare.drawing import PLAIN, add_legend, bare, look, save
from acoexp.compare.over_maps.budgets import Anytime, Curve
from acoexp.compare.over_maps.profiles import profile, ratios_to_best
from acoexp.compare.over_maps.values import CLOSE, MapValues, Matrix

_AXIS = {"cycles": "cycles", "ant steps": "ant steps, in lengths of the map's optimum"}


def draw_profiles(values: MapValues, folder: Path) -> None:
    """Write ``profiles.svg`` and ``profiles.png``: of the paths' lengths, and of the steps that they cost."""
    figure, panels = _two_panels()
    _draw_profile(panels[0], ratios_to_best(1.0 + values.gaps))
    _draw_profile(panels[1], ratios_to_best(values.costs))
    panels[0].set(xlabel="median length, as a multiple of the map's best", ylabel="share of maps")
    panels[1].set(xlabel=f"ant steps to within {100 * CLOSE:g} % of the optimum,\nas a multiple of the map's best")
    add_legend(figure, panels[0].get_lines(), values.configurations, "")
    save(figure, folder, "profiles")


def draw_targets(curves: Sequence[Sequence[Anytime]], folder: Path) -> None:
    """Write ``targets.svg`` and ``targets.png``: the share of targets hit, a panel for each unit of budgets."""
    figure, panels = _draw_anytime(curves, lambda one: (one.hit_low, one.hit, one.hit_high))
    for axes in panels:
        axes.set(ylim=(-0.02, 1.02))
        axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    panels[0].set(ylabel="share of trials and targets, mean over maps")
    save(figure, folder, "targets")


def draw_budgets(curves: Sequence[Sequence[Anytime]], folder: Path) -> None:
    """Write ``budgets.svg`` and ``budgets.png``: the gap that is left, a panel for each unit of budgets."""
    figure, panels = _draw_anytime(curves, lambda one: (one.gap_low, one.gap, one.gap_high))
    for axes in panels:
        axes.set_yscale("symlog", linthresh=1e-3)
        axes.set_ylim(bottom=-2e-4)
        axes.yaxis.set_major_formatter(FuncFormatter(lambda gap, _: f"{100.0 * gap:g} %"))
        axes.yaxis.set_minor_formatter(NullFormatter())
    panels[0].set(ylabel="gap to the optimum, median over maps")
    save(figure, folder, "budgets")


def _draw_profile(axes: Axes, ratios: Matrix) -> None:
    """Draw the profile of each configuration, to a little beyond the largest ratio that there is."""
    reached = ratios[np.isfinite(ratios)]
    last = max(float(reached.max(initial=1.0)) * 1.05, 1.02)
    for place, column in enumerate(ratios.T):
        factors = np.unique(np.concatenate([[1.0, last], column[np.isfinite(column)]]))
        axes.step(factors, profile(column, factors), where="post", **look(place))
    axes.set(xscale="log", xlim=(1.0, last), ylim=(-0.02, 1.02))
    ticks = [t for t in (1, 1.01, 1.02, 1.05, 1.1, 1.2, 1.5, 2, 3, 5, 10, 30, 100, 1000, 1e4) if t <= last]
    axes.set_xticks(_spread(ticks, last), minor=False)
    axes.xaxis.set_major_formatter(PLAIN)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    bare(axes)


def _spread(ticks: list[float], last: float) -> list[float]:
    """Return ticks that do not touch each other on a logarithmic axis from 1 to ``last``."""
    kept = [1.0]
    for tick in ticks:
        if np.log(tick / kept[-1]) > 0.09 * np.log(last):
            kept.append(float(tick))
    return kept


def _draw_anytime(
    curves: Sequence[Sequence[Anytime]], band: Callable[[Anytime], tuple[Curve, Curve, Curve]]
) -> tuple[Figure, Sequence[Axes]]:
    figure, panels = _two_panels()
    for axes, of_unit in zip(panels, curves, strict=True):
        for place, one in enumerate(of_unit):
            low, middle, high = (np.where(np.isinf(values), np.nan, values) for values in band(one))
            axes.fill_between(one.budgets, low, high, step="post", color=look(place)["color"], alpha=0.13, lw=0)
            axes.step(one.budgets, middle, where="post", **look(place))
        first, last = of_unit[0].budgets[[0, -1]]
        axes.set(xscale="log", xlim=(first, max(last, 1.1 * first)), xlabel=_AXIS[of_unit[0].unit])
        axes.xaxis.set_major_formatter(PLAIN)
        axes.xaxis.set_minor_formatter(NullFormatter())
        bare(axes)
    add_legend(figure, panels[0].get_lines(), [one.configuration for one in curves[0]], "")
    return figure, panels


def _two_panels() -> tuple[Figure, Sequence[Axes]]:
    figure = Figure(figsize=(9.5, 4.2), layout="constrained")
    panels: Sequence[Axes] = figure.subplots(1, 2, sharey=True)
    return figure, panels
