"""``map=image``: a floor plan as an image, dark where no path may lead.

A pixel is dark if the mean of its channels lies below ``threshold``; where it is transparent the white ground
shines through. ``scale`` x ``scale`` pixels are one cell, counted from the top left; at the right and below a cell
may have fewer. A cell is blocked if any of its pixels is dark.

Where ``start`` or ``goal`` is not given a dot marks it, green for the start, red for the goal: pixels that touch,
whose green (red) is at least 128 and at least twice each other channel. They are free. The cell of the dot's
centroid is meant.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.console.plain import printable
from acoexp.errors import MapError
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.maps.ends import check_free
from acoexp.maps.pixels import read_pixels
from acoexp.maps.reading import named_path
from acoexp.maps.source import MapSource
from acoexp.parameters import REQUIRED, parameter

_DOTS = {"start": ("green", 1), "goal": ("red", 0)}
"""What marks an end: the colour, and which channel that is."""


@dataclass(frozen=True, kw_only=True)
class Image(MapSource):
    """A floor plan as an image, dark where no path may lead; a green dot marks the start, a red one the goal."""

    path: str = parameter(REQUIRED, "the image: PNG, BMP, JPEG, TGA or PGM, relative to the working directory")
    start: Cell | None = parameter(None, "start as [row, column] in pixels from the top left; else a green dot")
    goal: Cell | None = parameter(None, "goal, likewise; else a red dot")
    threshold: float = parameter(0.5, "lightness below which a pixel is dark", minimum=0.0, maximum=1.0)
    scale: int = parameter(1, "side of a cell in pixels", minimum=1, maximum=10**4)
    moves: str = parameter("no_cut", "rule for diagonals", choices=MOVE_RULES)

    def load(self) -> Grid:
        """Read the image and return the grid."""
        path = named_path(self.path, "map.path")
        name = printable(path.name)
        colours = _on_white(read_pixels(path, "map.path", self.scale))
        dark = colours.sum(axis=2, dtype=np.uint16) < 765 * self.threshold
        pixels = {}
        for key, given in (("start", self.start), ("goal", self.goal)):
            if given is None:
                dots = _coloured(colours, _DOTS[key][1])
                dark &= ~dots
                pixels[key] = _centroid(dots, key, name)
            else:
                pixels[key] = _inside(given, key, name, dark.shape)
        obstacles = _pooled(dark, self.scale)
        start, goal = (self._cell(key, pixel, obstacles, name) for key, pixel in pixels.items())
        return Grid(obstacles, start=start, goal=goal, moves=self.moves, name=name)

    def _cell(self, key: str, pixel: Cell, obstacles: NDArray[np.bool_], name: str) -> Cell:
        """Return the cell that a pixel is in, if it can be entered."""
        cell = pixel[0] // self.scale, pixel[1] // self.scale

        def in_pixels(cell: Cell) -> str:
            return str([index * self.scale for index in cell])

        reason = (
            "an obstacle"
            if self.scale == 1
            else f"in a cell of {self.scale} x {self.scale} pixels with a dark one"
        )
        check_free(cell, obstacles, f"map {name}: {key} {list(pixel)}", reason, in_pixels, (self.scale, "pixels"))
        return cell


def _on_white(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return the colours, uint8[rows, columns, 3], that pixels have on a white ground."""
    colours, alpha = pixels[..., :3], pixels[..., 3]
    clear = alpha < 255
    if not clear.any():
        return colours
    colours = colours.copy()
    cover = alpha[clear, None] / 255
    colours[clear] = np.rint(255 - cover * (255.0 - colours[clear]))
    return colours


def _coloured(colours: NDArray[np.uint8], channel: int) -> NDArray[np.bool_]:
    """Return which pixels belong to a dot, bool[rows, columns]."""
    strong, (one, other) = colours[..., channel], (colours[..., c] for c in range(3) if c != channel)
    return (strong >= 128) & (one <= strong // 2) & (other <= strong // 2)


def _centroid(dots: NDArray[np.bool_], key: str, name: str) -> Cell:
    """Return the pixel in the middle of a dot, if it is the only one of its colour."""
    from scipy.ndimage import label

    rows, cols = np.nonzero(dots)
    around = dots[rows.min() : rows.max() + 1, cols.min() : cols.max() + 1] if len(rows) else dots[:0]
    count = label(around, structure=np.ones((3, 3)))[1]
    if count != 1:
        expected = f"map {name}: expected map.{key} as [row, column] in pixels, or one {_DOTS[key][0]} dot"
        raise MapError(f"{expected}; got {f'{count} separate ones' if count else 'neither'}")
    return int(rows.mean()), int(cols.mean())


def _inside(pixel: Cell, key: str, name: str, shape: tuple[int, ...]) -> Cell:
    if not (0 <= pixel[0] < shape[0] and 0 <= pixel[1] < shape[1]):
        raise MapError(
            f"map.{key}: expected a pixel from [0, 0] to [{shape[0] - 1}, {shape[1] - 1}], which map {name} "
            f"covers; got {list(pixel)}"
        )
    return pixel


def _pooled(dark: NDArray[np.bool_], scale: int) -> NDArray[np.bool_]:
    """Return which cells have a dark pixel, bool[rows, cols]."""
    blocks: NDArray[np.bool_] = dark
    for axis in (0, 1):
        blocks = np.logical_or.reduceat(blocks, np.arange(0, blocks.shape[axis], scale), axis=axis)
    return blocks
