"""Where pheromone lies after some cycles (Figs 7, 8 and 12)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from numpy.typing import NDArray

from acoexp.grid.grid import Grid
from acoexp.grid.moves import DIRECTIONS
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver
from acoexp_paper.figures.drawing import frame, new_figure

CYCLES = (6, 8, 10)
_LOWEST = 1e-4


def levels(grid: Grid, settings: Settings, seed: int, cycle: int) -> NDArray[np.float64]:
    """Return the pheromone of each cell after a cycle, summed over the edges into it; the highest is 1."""
    scalars = replace(settings.scalars, iterations=cycle)
    edges = np.nan_to_num(Solver(grid, replace(settings, scalars=scalars)).pheromone(seed))
    rows, cols = grid.shape
    into = np.zeros((rows + 2, cols + 2))
    for direction, (down, right) in enumerate(DIRECTIONS):
        into[1 + down : 1 + down + rows, 1 + right : 1 + right + cols] += edges[..., direction]
    share: NDArray[np.float64] = into[1:-1, 1:-1] / into[1:-1, 1:-1].max()
    return share


def draw_pheromone(grid: Grid, settings: Settings, seed: int) -> Figure:
    """Draw the pheromone of a trial's cells after each of three cycles."""
    figure = new_figure(3.0)
    panels = figure.subplots(1, len(CYCLES))
    edges = np.arange(grid.shape[1] + 1) - 0.5, np.arange(grid.shape[0] + 1) - 0.5
    for axes, cycle in zip(panels, CYCLES, strict=True):
        shown = np.ma.masked_where(grid.obstacles, np.maximum(levels(grid, settings, seed, cycle), _LOWEST))
        norm = LogNorm(_LOWEST, 1.0)
        picture = axes.pcolormesh(*edges, shown, cmap="cividis", norm=norm, edgecolors="face", linewidth=0.2)
        axes.set_facecolor("0.75")
        frame(axes, grid)
        for line in axes.lines:
            line.set(color="white", markeredgecolor="black")
        axes.set_title(f"after cycle {cycle}", fontsize=9)
        axes.label_outer()
    figure.colorbar(picture, ax=panels, shrink=0.8, label="pheromone (share of highest)", extend="min")
    return figure
