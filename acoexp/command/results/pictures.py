"""Pictures of one trial: the map with its path, and the convergence curve."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, StrMethodFormatter
from matplotlib.transforms import Affine2D
from numpy.typing import ArrayLike, NDArray

from acoexp.grid.grid import Grid
from acoexp.report.labels import any_signs, as_it_is
from acoexp.report.palette import BLUE, GREEN, ORANGE
from acoexp.trial.result import Result

_SMALL = 64
"""Rows and columns up to which a map is drawn as a whole, and cell by cell."""

_WIDTH, _PIXELS, _MOST_PIXELS = 5.4, 100, 1900
"""Of a map in inches; of an inch; of a picture that a screen can show."""


def draw_map(result: Result, file: Path) -> None:
    """Draw the map with the returned path, and with the path as it was walked if that differs.

    Axes are in metres where the map has a frame, else in cells. Of a map of more than 64 rows or columns no more
    is drawn than has free cells, and than what lies about the paths.
    """
    grid, path, raw = result.grid, result.path, result.raw_path
    if raw is not None and path is not None and np.array_equal(raw, path):
        raw = None
    figure, axes = _figure_of(grid, [cells for cells in ([grid.start, grid.goal], path, raw) if cells is not None])
    side, unit = (1.0, "") if grid.frame is None else (grid.frame.resolution, " m")
    if raw is not None:
        look = {"linewidth": 1.5, "linestyle": "--"} if _is_small(grid) else {"linewidth": 0.6, "alpha": 0.5}
        axes.plot(*_placed(grid, raw).T, color=ORANGE, label="as walked", **look)
    if path is not None:
        label = f"path, {side * result.length:.4f}{unit}"
        axes.plot(*_placed(grid, path).T, color=BLUE, linewidth=2.5 if _is_small(grid) else 1.8, label=label)
    for name, cell, marker, size in (("start", grid.start, "o", 6), ("goal", grid.goal, "*", 12)):
        axes.plot(*_placed(grid, [cell]).T, marker, color=GREEN, markersize=size, clip_on=False, label=name)
    of = as_it_is(f"{result.algo} on {grid.name}")
    axes.set_title(f"{of}, seed {result.seed} (optimum {side * result.optimum:.4f}{unit})", wrap=True)
    axes.set(xlabel="x (m)" if grid.frame else "column", ylabel="y (m)" if grid.frame else "row")
    figure.legend(loc="outside lower center", ncols=4, frameon=False)
    _save(figure, file)


def _is_small(grid: Grid) -> bool:
    return max(grid.shape) <= _SMALL


def _placed(grid: Grid, cells: ArrayLike) -> NDArray[np.float64]:
    """Return the centres of cells as they are drawn, float[n, 2]: (x, y) in metres, or (column, row)."""
    if grid.frame is not None:
        return grid.frame.to_metres(cells)
    return np.asarray(cells, dtype=np.float64).reshape(-1, 2)[:, ::-1]


def _part(grid: Grid, paths: Sequence[ArrayLike]) -> tuple[slice, slice]:
    """Return the rows and columns that are drawn: about the paths, which take up a third of them or more."""
    if _is_small(grid):
        return slice(0, grid.shape[0]), slice(0, grid.shape[1])
    cells = np.concatenate(paths)
    nearest, farthest = cells.min(axis=0), cells.max(axis=0)
    about = max(int((farthest - nearest).max()), _SMALL // 2)
    free = [np.flatnonzero(~grid.obstacles.all(axis=across)) for across in (1, 0)]
    first = np.maximum(nearest - about, [lines[0] - 2 for lines in free]).clip(min=0).tolist()
    last = np.minimum(farthest + about, [lines[-1] + 2 for lines in free]).tolist()  # a slice ends with the map
    return slice(first[0], last[0] + 1), slice(first[1], last[1] + 1)


def _figure_of(grid: Grid, paths: Sequence[ArrayLike]) -> tuple[Figure, Axes]:
    """Return a figure with the map about paths on its axes, in two pixels a cell as far as a screen has them."""
    part = _part(grid, paths)
    obstacles = grid.obstacles[part]
    top, left = part[0].start - 0.5, part[1].start - 0.5
    bottom, right = top + obstacles.shape[0], left + obstacles.shape[1]
    corners = _placed(grid, [(bottom, left), (bottom, right), (top, right), (top, left)])
    low, high = corners.min(axis=0), corners.max(axis=0)
    width, height = high - low
    size = 6.0, min(max(_WIDTH * height / width, 1.5), 16.0) + 1.2
    pixels = min(max(2 * max(obstacles.shape) / _WIDTH, _PIXELS), _MOST_PIXELS / max(size))
    figure = Figure(figsize=size, dpi=pixels, layout="constrained")
    axes = figure.subplots()
    _draw_obstacles(axes, grid, obstacles, (left, right, bottom, top))
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(*((low[1], high[1]) if grid.frame else (high[1], low[1])))
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(integer=grid.frame is None))
    return figure, axes


def _draw_obstacles(
    axes: Axes, grid: Grid, obstacles: NDArray[np.bool_], extent: tuple[float, float, float, float]
) -> None:
    """Draw a part of the map, its extent in cells: left, right, bottom, top."""
    left, right, bottom, top = extent
    axes.set_facecolor("0.9")  # outside of a map that is turned there is no free ground, which is white
    zero, one_down, one_right = _placed(grid, [(0, 0), (1, 0), (0, 1)])
    turned = Affine2D.from_values(*(one_right - zero), *(one_down - zero), *zero)
    image = axes.imshow(obstacles, cmap="Greys", vmin=0, vmax=1.6, interpolation_stage="data", extent=extent)
    image.set_transform(turned + axes.transData)
    if _is_small(grid):
        across = [_placed(grid, [(line, left), (line, right)]) for line in np.arange(top, bottom + 1)]
        down = [_placed(grid, [(top, line), (bottom, line)]) for line in np.arange(left, right + 1)]
        lines = LineCollection([*across, *down], colors="0.85", linewidths=0.5, zorder=1)
        axes.add_collection(lines, autolim=False)


def draw_convergence(result: Result, file: Path) -> None:
    """Draw the best length found in each cycle, and the exact optimum."""
    figure = Figure(figsize=(7, 4), layout="constrained")
    axes = figure.subplots()
    cycles = np.arange(1, len(result.curve) + 1)
    axes.axhline(result.optimum, color=GREEN, linestyle=":", label=f"optimum, {result.optimum:.4f}")
    axes.plot(cycles, result.curve, color=BLUE, label="best in the cycle")
    for cycle, length, name, marker in ((result.x1, result.l1, "x1", "o"), (result.x3, result.l2, "x3", "s")):
        if cycle > 0:
            label = f"{name} = {cycle}, {length:.4f}"
            axes.plot(cycle, length, marker, color=ORANGE, fillstyle="none", markersize=9, label=label)
    axes.set(
        title=f"{as_it_is(f'{result.algo} on {result.grid.name}')}, seed {result.seed}",
        xlabel="cycle (log scale)",
        xscale="log",
        ylabel="path length (cells)",
    )
    axes.set_xlim(0.9, len(cycles) * 1.1)
    axes.xaxis.set_major_formatter(StrMethodFormatter("{x:.0f}"))
    axes.legend(frameon=False)
    _save(figure, file)


def _save(figure: Figure, file: Path) -> None:
    FigureCanvasAgg(figure)
    with any_signs():
        figure.savefig(file)
