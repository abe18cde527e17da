"""The ensembles: further reconstructions of each map, with exactly its optimum."""

from __future__ import annotations

import pytest

from acoexp import Grid, MapError
from acoexp.maps import ensemble
from acoexp.maps.builtin import Env1, Env2, Fig13

MAPS = pytest.mark.parametrize("source", [Fig13, Env1, Env2])


def others(source: type) -> tuple[Grid, list[Grid]]:
    """Return a built-in map, and its ensemble."""
    return source().load(), ensemble(source.name)


@MAPS
def test_they_are_called_after_their_map_and_the_seed_of_their_search_in_order(source: type) -> None:
    names = [grid.name for grid in ensemble(source.name)]
    assert names == sorted(names)
    assert len(names) > 1
    assert all(name.rpartition("-")[0] == source.name and name.rpartition("-")[2].isdigit() for name in names)


@MAPS
def test_each_has_the_maps_optimum_size_and_ends_whatever_its_rule_for_diagonals(source: type) -> None:
    built_in, further = others(source)
    for grid in further:
        assert grid.optimum_pair == built_in.optimum_pair
        assert (grid.shape, grid.start, grid.goal) == (built_in.shape, built_in.start, built_in.goal)


@MAPS
def test_no_two_are_alike_and_none_is_the_built_in_one(source: type) -> None:
    built_in, further = others(source)
    assert len({grid.digest for grid in [built_in, *further]}) == len(further) + 1


@MAPS
def test_each_says_how_well_it_fits(source: type) -> None:
    assert all("fit" in grid.metadata for grid in ensemble(source.name))


def test_a_map_that_has_no_ensemble_is_refused() -> None:
    with pytest.raises(MapError, match=r"ensemble: expected one of: fig13, env1, env2; got 'yard'"):
        ensemble("yard")
