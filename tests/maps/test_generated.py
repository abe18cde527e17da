"""Maps by chance: what all kinds have in common. A seed means one map, for ever, with a way on it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference import moves_of
from samples import reach_of

from acoexp import Grid, MapError, SettingsError, load_map
from acoexp.grid import MOVE_RULES
from acoexp.maps.generated import DRAWS

KINDS = ("random", "rectangles", "maze", "rooms")


@pytest.mark.parametrize(
    ("kind", "digest"),
    [
        ("random", "2f04ccd4f1cc4c82"),
        ("rectangles", "169ec587d22f24e5"),
        ("maze", "85ae7bea798fd16b"),
        ("rooms", "e1130c8ca0815f51"),
    ],
)
def test_a_seed_means_the_same_map_for_ever(kind: str, digest: str) -> None:
    """Results that are kept or published name a map by its parameters alone."""
    assert load_map(kind).digest == digest


@pytest.mark.parametrize("kind", KINDS)
def test_other_seeds_mean_other_maps(kind: str) -> None:
    assert len({load_map(kind, seed=seed).digest for seed in (0, 1, 2, 2**64 - 1)}) == 4


@pytest.mark.parametrize("kind", KINDS)
def test_a_map_says_in_its_name_and_metadata_how_it_is_had_again(kind: str) -> None:
    grid = load_map(kind, size=(20, 31), seed=7, moves="free")
    assert grid.name.startswith(f"{kind}-20x31-")
    assert grid.name.endswith("-s7")
    assert (grid.shape, grid.moves, grid.start, grid.goal) == ((20, 31), "free", (0, 0), (19, 30))
    assert {key: grid.metadata[key] for key in ("size", "seed", "moves")} == {
        "size": "(20, 31)",
        "seed": "7",
        "moves": "free",
    }


@settings(deadline=None, max_examples=60)
@given(
    st.sampled_from(KINDS),
    st.integers(1, 14),
    st.integers(2, 14),
    st.integers(0, 2**64 - 1),
    st.sampled_from(MOVE_RULES),
    st.data(),
)
def test_a_way_leads_between_any_ends_or_it_is_said(
    kind: str, rows: int, cols: int, seed: int, moves: str, data: st.DataObject
) -> None:
    cells = st.tuples(st.integers(0, rows - 1), st.integers(0, cols - 1))
    start, goal = data.draw(st.lists(cells, min_size=2, max_size=2, unique=True))
    try:
        grid = load_map(kind, size=(rows, cols), seed=seed, moves=moves, start=start, goal=goal)
    except MapError as problem:
        assert f"it did on none of {DRAWS} maps" in str(problem)  # noqa: PT017
        return
    assert (grid.start, grid.goal) == (start, goal)
    assert goal in reach_of(moves_of(grid), start)


def test_where_chance_finds_no_way_it_is_said_after_so_many_maps() -> None:
    with pytest.raises(MapError) as caught:
        load_map("random", density=1.0, size=(9, 9))
    assert str(caught.value) == (
        "map random-9x9-d1-s0: expected settings under which a way leads from start (0, 0) to goal (8, 8); "
        "it did on none of 100 maps"
    )


def test_maps_without_a_way_are_drawn_anew() -> None:
    """At this density few maps have a way; each of these seeds comes to one of its own."""
    found = [load_map("random", density=0.4, size=(12, 12), seed=seed) for seed in range(10)]
    assert len({grid.digest for grid in found}) == 10


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("parameters", "said"),
    [
        ({"size": (0, 5)}, r"^map\.size: expected rows and columns, each from 1 to 2048; got \[0, 5\]"),
        ({"size": (5, 2049)}, r"^map\.size: expected rows and columns, each from 1 to 2048; got \[5, 2049\]"),
        ({"size": (10**999, 5)}, r"^map\.size: expected rows and columns, each from 1 to 2048; got "),
        ({"size": 5}, r"^map\.size: expected a pair"),
        ({"size": (5, 5, 5)}, r"^map\.size: expected a pair"),
        (
            {"size": (5, 5), "start": (5, 0)},
            r"^map\.start: expected a cell from \[0, 0\] to \[4, 4\]; got \[5, 0\]",
        ),
        (
            {"size": (5, 5), "goal": (-1, 0)},
            r"^map\.goal: expected a cell from \[0, 0\] to \[4, 4\]; got \[-1, 0\]",
        ),
        ({"size": (5, 5), "goal": (0, 0)}, "start and goal are one cell"),
        ({"size": (1, 1)}, "start and goal are one cell"),
        ({"seed": -1}, r"^map\.seed: expected a whole number from 0 to 2\^64 - 1; got -1"),
        ({"seed": 1.5}, r"^map\.seed: expected a whole number from 0 to 2\^64 - 1; got 1\.5"),
        ({"moves": "jump"}, r"^map\.moves: expected one of: "),
    ],
)
def test_what_no_map_can_be_made_of_is_refused(kind: str, parameters: dict[str, Any], said: str) -> None:
    with pytest.raises((SettingsError, MapError), match=said):
        load_map(kind, **parameters)


@pytest.mark.parametrize("kind", KINDS)
def test_the_largest_map_is_drawn(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without its optimum, which costs the same whatever a map comes from."""
    made: list[np.ndarray] = []

    def small(obstacles: np.ndarray, **_: object) -> Grid:
        made.append(obstacles)
        return Grid([[0, 0]])

    monkeypatch.setattr("acoexp.maps.generated.Grid", small)
    load_map(kind, size=(2048, 2048))
    assert made[0].shape == (2048, 2048)


def test_a_grid_of_a_source_is_one_like_any_other() -> None:
    grid = load_map("random", size=(9, 9))
    assert Grid(grid.obstacles, moves=grid.moves).digest == grid.digest
