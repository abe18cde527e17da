"""A result: the path follows from its moves, lengths are exact, and what is not there is None."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from acoexp import Grid, Result

E, NE, N, NW, W, SW, S, SE = range(8)

YARD = Grid([[0, 0, 0], [0, 0, 0], [0, 0, 0]], name="yard")
WALKED, BEST = [E, E, S, S], [SE, SE]
SQRT8 = math.sqrt(8.0)


def result(*pairs: tuple[int, int], moves: list[int] | None = BEST, raw_moves: list[int] | None = None) -> Result:
    """Return a result whose cycles found paths of so many (straight, diagonal) moves."""
    return Result(
        algo="aco",
        seed=3,
        grid=YARD,
        moves=None if moves is None else np.array(moves, dtype=np.uint8),
        raw_moves=None if raw_moves is None else np.array(raw_moves, dtype=np.uint8),
        curve_pairs=np.array(pairs, dtype=np.int32),
        lost_ants=np.array([pair[0] < 0 for pair in pairs], dtype=np.int32),
        cycle_steps=np.full(len(pairs), 12 // len(pairs)),
    )


LOST = result((-1, -1), (-1, -1), moves=None)


def test_a_path_begins_on_the_start_and_follows_its_moves() -> None:
    both = result((0, 2), raw_moves=WALKED)
    assert both.path is not None
    assert both.raw_path is not None
    assert both.path.tolist() == [[0, 0], [1, 1], [2, 2]]
    assert both.raw_path.tolist() == [[0, 0], [0, 1], [0, 2], [1, 2], [2, 2]]


def test_its_features_are_those_of_its_curve() -> None:
    found = result((4, 0), (0, 2), (2, 1), (0, 2), (2, 1))
    assert (found.x1, found.x2, found.x3) == (2, 4, 5)
    assert (found.l1, found.l2, found.length) == (SQRT8, 2.0 + math.sqrt(2.0), SQRT8)


def test_in_its_other_reading_x2_is_the_last_cycle_that_found_the_best_length() -> None:
    found = result((0, 2), (0, 2), (4, 0), (0, 2), (4, 0))
    assert (found.x2, found.x2_last) == (1, 4)


def test_lengths_are_known_exactly_as_pairs_of_moves() -> None:
    found = result((4, 0), (0, 2), (-1, -1), (2, 1))
    assert (found.l1_pair, found.l2_pair, found.optimum_pair) == ((0, 2), (2, 1), (0, 2))


def test_where_the_last_cycle_lost_all_ants_there_is_no_length_of_convergence() -> None:
    found = result((0, 2), (-1, -1))
    assert found.l1_pair == (0, 2)
    assert found.l2_pair is None
    assert math.isnan(found.l2)


def test_the_optimum_is_found_by_moves_and_not_by_rounded_lengths() -> None:
    assert result((4, 0), (0, 2)).found_optimum
    assert not result((4, 0), (2, 1)).found_optimum
    assert not LOST.found_optimum


def test_it_says_everything_as_json_with_null_for_what_is_not_there() -> None:
    said: dict[str, Any] = json.loads(json.dumps(result((-1, -1), (0, 2), (-1, -1)).as_dict(), allow_nan=False))
    assert (said["algo"], said["map"], said["seed"], said["map_digest"]) == ("aco", "yard", 3, YARD.digest)
    assert (said["x1"], said["l1"], said["l1_pair"], said["optimum"]) == (2, SQRT8, [0, 2], SQRT8)
    assert (said["l2"], said["l2_pair"], said["raw_path"]) == (None, None, None)
    assert said["curve"] == [None, SQRT8, None]
    assert (said["lost_ants"], said["ant_steps"], said["cycles"]) == ([1, 0, 1], 12, 3)
    assert (said["turns"], said["detour"]) == (0.0, pytest.approx(1.0))
    assert said["path"] == [[0, 0], [1, 1], [2, 2]]


def test_where_no_ant_ever_arrived_only_the_map_is_known() -> None:
    said = LOST.as_dict()
    assert {key for key, value in said.items() if value is None} == {
        "l1", "l2", "l1_pair", "l2_pair", "path", "raw_path",
        "turns", "turning", "clearance_mean", "clearance_least", "detour",
    }  # fmt: skip
    assert said["optimum_pair"] == (0, 2)


def test_at_a_prompt_it_is_one_line() -> None:
    assert repr(result((4, 0), (0, 2), (-1, -1))) == (
        "<aco on yard, seed 3: l1=2.8284 l2=nan x1=2 x2=2 x3=0, optimum 2.8284, 1 ants lost>"
    )


def test_where_no_ant_ever_arrived_it_says_how_far_they_came() -> None:
    assert LOST.lost_after == 6.0  # twelve moves of two ants
    assert repr(LOST) == (
        "<aco on yard, seed 3: no ant arrived: they were lost after 6 moves on average, and the goal is 3 cells "
        "away, optimum 2.8284, 2 ants lost>"
    )
    assert math.isnan(result((4, 0)).lost_after)
