"""What all figures share: size, colours, the look of a map, and how a figure becomes two files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from acoexp.grid.grid import Grid
from acoexp.report.palette import BLUE, GREEN, ORANGE

WIDTH = 7.2
"""Inches; two columns of a journal."""

COLOURS = {"aco": ORANGE, "pd": BLUE, "pdg": GREEN, "pf": "#CC79A7"}
"""Okabe and Ito's, which the colour-blind can distinguish."""

DASHES = {"aco": "--", "pd": "-", "pdg": "-.", "pf": ":"}
HATCHES = {"aco": "//", "pd": "", "pdg": "..", "pf": "xx"}


def new_figure(height: float, width: float = WIDTH) -> Figure:
    """Return an empty figure, so many inches high."""
    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def save(figure: Figure, folder: Path, name: str) -> str:
    """Write a figure as SVG and PNG, the same bytes for the same content, and return the SVG's text."""
    with rc_context({"svg.hashsalt": name}):
        figure.savefig(folder / f"{name}.svg", metadata={"Date": None, "Creator": None})
    figure.savefig(folder / f"{name}.png", dpi=200, metadata={"Software": None})
    return (folder / f"{name}.svg").read_text(encoding="utf-8")


def draw_grid(axes: Axes, grid: Grid) -> None:
    """Draw a map, its cells' centres at whole numbers, row 0 on top."""
    rows, cols = grid.shape
    edges = np.arange(cols + 1) - 0.5, np.arange(rows + 1) - 0.5
    shown = np.ma.masked_where(~grid.obstacles, np.ones(grid.shape))
    axes.pcolormesh(*edges, shown, cmap="Greys", vmin=0, vmax=2, edgecolors="face", linewidth=0.2)
    frame(axes, grid)


def frame(axes: Axes, grid: Grid) -> None:
    """Give a map's axes their limits, names and ends."""
    rows, cols = grid.shape
    axes.set(
        xlim=(-0.5, cols - 0.5),
        ylim=(rows - 0.5, -0.5),
        aspect="equal",
        xlabel="column (cells)",
        ylabel="row (cells)",
    )
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(5, integer=True))
    axes.plot(*grid.start[::-1], "o", color="black", markersize=5, zorder=5)
    axes.plot(*grid.goal[::-1], "*", color="black", markersize=9, zorder=5)
