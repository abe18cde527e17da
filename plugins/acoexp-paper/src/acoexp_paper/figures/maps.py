"""Maps: the potential field's forces (Fig. 1), and paths before and after the post-optimiser (13, 14, 17)."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from acoexp.grid.field import FieldSettings, potential_field
from acoexp.grid.grid import Grid
from acoexp.grid.moves import path_length
from acoexp.report.palette import BLUE, ORANGE
from acoexp.trial.result import Result
from acoexp_paper.figures.drawing import draw_grid, new_figure
from acoexp_paper.published.tables import ENVIRONMENTS


def draw_fields(maps: Mapping[str, Grid], settings: FieldSettings) -> Figure:
    """Draw on each map the direction of the resultant force, and the edge along which pheromone diffuses."""
    figure = new_figure(3.1)
    for axes, (env, grid) in zip(figure.subplots(1, len(maps)), maps.items(), strict=True):
        draw_grid(axes, grid)
        _draw_forces(axes, grid, settings)
        axes.set_title(f"{env} ({ENVIRONMENTS[env].title.split(' (')[0]})", fontsize=8)
        axes.label_outer()
    return figure


def _draw_forces(axes: Axes, grid: Grid, settings: FieldSettings) -> None:
    field = potential_field(grid.obstacles, grid.goal, settings)
    free = ~grid.obstacles
    row, col = np.nonzero(free)
    force, sector = field.force[free], field.sector[free]
    direction = force / np.maximum(np.hypot(*force.T), 1e-12)[:, None]
    open_edge = (sector < 8) & (grid.allowed[free] >> np.minimum(sector, 7) & 1).astype(bool)
    for chosen, colour in ((open_edge, BLUE), (~open_edge & (sector < 8), ORANGE)):
        axes.quiver(
            col[chosen], row[chosen], *direction[chosen].T,
            color=colour, pivot="mid", angles="uv", scale=24, width=0.006, headwidth=4.5,
        )  # fmt: skip


def draw_path(title: str, result: Result) -> Figure:
    """Draw the returned path of a trial, and that path as the ant walked it, on its map."""
    figure = new_figure(4.1, 4.4)
    axes = figure.subplots()
    draw_grid(axes, result.grid)
    if result.raw_path is not None:
        _plot(axes, result.raw_path, BLUE, "--", 1.3, f"as walked, {length_of(result.raw_path):.4f} cells")
    if result.path is not None:
        _plot(axes, result.path, ORANGE, "-", 2.2, f"optimised, {result.length:.4f} cells")
    axes.set_title(title, fontsize=9)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), fontsize=8, frameon=False)
    return figure


def _plot(axes: Axes, path: NDArray[np.int64], colour: str, dash: str, width: float, label: str) -> None:
    rows, cols = path.T
    axes.plot(cols, rows, dash, color=colour, linewidth=width, label=label, solid_joinstyle="round", zorder=4)


def length_of(path: NDArray[np.int64]) -> float:
    """Return the length of a path, int[n, 2], in cells."""
    diagonal = int((np.abs(np.diff(path, axis=0)).sum(axis=1) == 2).sum())
    return path_length(len(path) - 1 - diagonal, diagonal)
