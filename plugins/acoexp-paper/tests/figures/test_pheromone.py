"""Where pheromone lies, on trails that are made up."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.figures import pheromone
from acoexp_paper.figures.pheromone import CYCLES, draw_pheromone, levels

from acoexp.grid.grid import Grid
from acoexp.grid.moves import DIRECTIONS
from acoexp.registry.resolve import resolve
from acoexp.trial.settings import Settings

YARD = Grid([[0, 0, 1], [0, 0, 0]])
SETTINGS = resolve("aco", {})


class Laid:
    """A solver whose ants lay more with each cycle on two edges into (1, 1), and always 4 on one into (0, 1)."""

    def __init__(self, grid: Grid, settings: Settings) -> None:
        self.cycles = settings.scalars.iterations

    def pheromone(self, seed: int) -> np.ndarray:
        trails = np.full((2, 3, 8), np.nan)
        trails[0, 0, DIRECTIONS.index((1, 1))] = 3.0 * self.cycles
        trails[1, 2, DIRECTIONS.index((0, -1))] = 1.0 * self.cycles
        trails[0, 0, DIRECTIONS.index((0, 1))] = 4.0
        return trails


@pytest.fixture(autouse=True)
def _laid(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pheromone, "Solver", Laid)


@pytest.mark.parametrize("cycle", [1, 4])
def test_a_cells_level_is_the_sum_over_the_edges_into_it_as_a_share_of_the_highest(cycle: int) -> None:
    np.testing.assert_array_equal(levels(YARD, SETTINGS, 0, cycle), [[0, 1 / cycle, 0], [0, 1, 0]])


def test_a_panel_shows_each_of_three_cycles_with_obstacles_left_out() -> None:
    *panels, _ = draw_pheromone(YARD, SETTINGS, 0).axes
    assert [axes.get_title() for axes in panels] == [f"after cycle {cycle}" for cycle in CYCLES]
    for axes, cycle in zip(panels, CYCLES, strict=True):
        shown = axes.collections[0].get_array().reshape(2, 3)
        np.testing.assert_array_equal(np.ma.getmaskarray(shown), YARD.obstacles)
        assert (shown[0, 1], shown[1, 1]) == (1 / cycle, 1.0)
        assert shown[0, 0] == 1e-4  # nothing, on a scale that has no 0
