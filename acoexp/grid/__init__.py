"""The grid that paths are planned on: occupancy, start, goal, allowed moves, exact optimum."""

from acoexp.grid.frame import Frame
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import DIRECTIONS, MOVE_RULES, SQRT2, allowed_moves, follow, path_length

__all__ = ["DIRECTIONS", "MOVE_RULES", "SQRT2", "Cell", "Frame", "Grid", "allowed_moves", "follow", "path_length"]
