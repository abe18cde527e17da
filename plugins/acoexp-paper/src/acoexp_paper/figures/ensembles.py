"""Pictures of all maps of an environment, each with how well it fits."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil

import numpy as np
from matplotlib.figure import Figure

from acoexp.grid.grid import Grid
from acoexp_paper.figures.drawing import new_figure

_IN_A_ROW = 8


def draw_maps(maps: Sequence[Grid], scored: bool) -> Figure:
    """Draw maps side by side, each under its name, its rule for diagonals and, if they are scored, its score."""
    rows = ceil(len(maps) / _IN_A_ROW)
    figure = new_figure(1.16 * rows)
    panels = figure.subplots(rows, _IN_A_ROW, squeeze=False).ravel()
    for axes, grid in zip(panels, maps, strict=False):
        shown = np.where(grid.obstacles, 0.45, 1.0)
        axes.imshow(shown, cmap="gray", vmin=0, vmax=1, interpolation="none")
        score = grid.metadata.get("score") if scored else None
        said = f"{grid.name}\n{grid.moves}" + (f", {float(score):.1f}" if score else "")
        axes.set_title(said, fontsize=6, pad=2)
        axes.plot(*grid.start[::-1], "o", color="black", markersize=2)
        axes.plot(*grid.goal[::-1], "*", color="black", markersize=3)
    for axes in panels:
        axes.set(xticks=[], yticks=[])
    for axes in panels[len(maps) :]:
        axes.set_visible(False)
    return figure
