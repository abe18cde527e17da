"""Pictures of one trial: the map with its path, and the convergence curve."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, StrMethodFormatter

from acoexp.report.labels import any_signs, as_it_is
from acoexp.report.palette import BLUE, GREEN, ORANGE
from acoexp.trial.result import Result


def draw_map(result: Result, file: Path) -> None:
    """Draw the map with the returned path, and with the path as it was walked if that differs."""
    grid = result.grid
    rows, cols = grid.shape
    figure = Figure(figsize=(6, min(max(5.4 * rows / cols, 1.5), 16) + 1.2), layout="constrained")
    axes = figure.subplots()
    axes.imshow(grid.obstacles, cmap="Greys", vmin=0, vmax=1.6, interpolation="nearest")
    if max(rows, cols) <= 64:
        axes.set_xticks(np.arange(cols + 1) - 0.5, minor=True)
        axes.set_yticks(np.arange(rows + 1) - 0.5, minor=True)
        axes.grid(which="minor", color="0.85", linewidth=0.5)
        axes.tick_params(which="minor", length=0)
    raw, path = result.raw_path, result.path
    if raw is not None and path is not None and not np.array_equal(raw, path):
        axes.plot(*raw.T[::-1], color=ORANGE, linewidth=1.5, linestyle="--", label="as walked")
    if result.path is not None:
        label = f"path, {result.length:.4f}"
        axes.plot(*result.path.T[::-1], color=BLUE, linewidth=2.5, label=label)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(integer=True))
    axes.plot(*grid.start[::-1], "o", color=GREEN, label="start")
    axes.plot(*grid.goal[::-1], "*", color=GREEN, markersize=12, label="goal")
    axes.set(
        title=f"{as_it_is(f'{result.algo} on {grid.name}')}, seed {result.seed} (optimum {result.optimum:.4f})",
        xlabel="column",
        ylabel="row",
    )
    figure.legend(loc="outside lower center", ncols=4, frameon=False)
    _save(figure, file)


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
