"""The built-in maps: what each says of itself, and that it is what it says."""

from __future__ import annotations

import numpy as np
import pytest
from reference import moves_of
from samples import reach_of

from acoexp import Grid, SettingsError
from acoexp.grid import MOVE_RULES
from acoexp.maps.builtin import BuiltinMap, Env1, Env2, Fig13
from acoexp.parameters import build

SOURCES = pytest.mark.parametrize("source", [Fig13, Env1, Env2])


def load(source: type[BuiltinMap], **options: str) -> Grid:
    """Load a map, its parameters checked."""
    grid: Grid = build(source, options, "map.").load()
    return grid


@SOURCES
def test_a_map_is_20_x_20_from_corner_to_corner(source: type[BuiltinMap]) -> None:
    grid = load(source)
    assert grid.name == source.name
    assert (grid.shape, grid.start, grid.goal) == ((20, 20), (0, 0), (19, 19))


@SOURCES
def test_a_map_says_that_it_is_a_reconstruction_and_how_well_it_fits(source: type[BuiltinMap]) -> None:
    metadata = load(source).metadata
    assert {"moves", "origin", "optimum", "fit"} <= metadata.keys()
    assert "reconstruction" in metadata["origin"]
    assert "standard ACO alone" in metadata["origin"]
    assert "fresh" in metadata["fit"]


@SOURCES
def test_a_map_declares_its_rule_and_the_optimum_that_it_has(source: type[BuiltinMap]) -> None:
    grid = load(source)
    straight, diagonal = grid.optimum_pair
    assert grid.metadata["moves"] == grid.moves
    assert grid.metadata["optimum"] == f"{straight} straight, {diagonal} diagonal"


@SOURCES
def test_a_map_is_neither_empty_nor_crammed(source: type[BuiltinMap]) -> None:
    assert 0.15 < load(source).obstacles.mean() < 0.40


@SOURCES
def test_obstacles_are_bars_and_blocks_not_noise(source: type[BuiltinMap]) -> None:
    """No obstacle stands alone: each has another one above, below or beside it."""
    wide = np.pad(load(source).obstacles, 1)
    beside = wide[:-2, 1:-1] | wide[2:, 1:-1] | wide[1:-1, :-2] | wide[1:-1, 2:]
    assert beside[wide[1:-1, 1:-1]].all()


@SOURCES
def test_every_free_cell_can_be_reached(source: type[BuiltinMap]) -> None:
    grid = load(source)
    assert len(reach_of(moves_of(grid), grid.start)) == (~grid.obstacles).sum()


def test_no_two_maps_are_one() -> None:
    assert len({load(source).obstacles.tobytes() for source in (Fig13, Env1, Env2)}) == 3


@pytest.mark.parametrize("rule", MOVE_RULES)
def test_another_rule_may_be_asked_for(rule: str) -> None:
    grid = load(Fig13, moves=rule)
    assert grid.moves == rule
    assert (grid.obstacles == load(Fig13).obstacles).all()


def test_an_unknown_rule_is_refused() -> None:
    with pytest.raises(
        SettingsError, match=r"map.moves: expected one of: free, no_squeeze, no_cut, four; got 'none'"
    ):
        load(Fig13, moves="none")
