"""What is packed for the page is what was recorded."""

from __future__ import annotations

import zlib
from base64 import b64decode
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from acoexp import Recording, record
from acoexp.grid.field import FieldSettings, potential_field
from acoexp.grid.moves import follow
from acoexp.watch.packing import MOST_ANTS, WIDEST, Scale, packed, packed_map

pytestmark = pytest.mark.slow_without_jit


def unpacked(text: str, kind: str = "u1") -> NDArray[Any]:
    return np.frombuffer(zlib.decompress(b64decode(text)), dtype=kind)


def test_pheromone_is_told_within_two_percent(recording: Recording) -> None:
    colony = packed("pdg", recording).colony
    touched = np.cumsum(unpacked(colony["touched"], "<u4"))
    changes = unpacked(colony["frames"]).reshape(13, -1)
    bytes_ = np.repeat(unpacked(colony["common"])[:, None], 400, axis=1)
    bytes_[:, touched] = np.cumsum(changes, axis=0, dtype=np.uint8)
    for cycle, (low, high) in enumerate(colony["scales"]):
        levels = recording.pheromone[cycle].ravel()
        told = low * (high / low) ** (bytes_[cycle] / 255.0)
        on_scale = levels >= low
        assert told[on_scale] == pytest.approx(levels[on_scale], rel=0.02)
        assert not bytes_[cycle][~on_scale].any()
        assert high <= 1.001 * WIDEST * low


def test_what_has_evaporated_to_nothing_is_the_weakest_and_the_strongest_still_stands_out() -> None:
    long = record("fig13", "pdg", seed=1)
    last = long.pheromone[-1]
    assert (last[long.grid.allowed > 0] == 0.0).any()
    low, high = packed("pdg", long).colony["scales"][-1]
    assert high == pytest.approx(last.max())
    assert high == pytest.approx(WIDEST * low)


def test_ways_are_told_exactly(recording: Recording) -> None:
    colony = packed("pdg", recording).colony
    turns, steps = unpacked(colony["turns"]), unpacked(colony["steps"], "<u4")
    each = np.split(turns, np.cumsum(steps)[:-1])
    ways = [way for cycle in range(1, 13) for way in recording.ways(cycle)]
    assert [(np.cumsum(way) % 8).tolist() for way in each] == [way.moves.tolist() for way in ways]
    assert unpacked(colony["stuck"]).tolist() == [way.lost for way in ways]
    assert unpacked(colony["winners"]).tolist() == recording.winners.tolist()


def test_of_very_many_ants_some_are_shown_and_the_best_among_them() -> None:
    crowd = record("fig13", "aco", seed=1, iterations=4, ants=500)
    colony = packed("aco", crowd).colony
    assert (colony["ants"], colony["shown"]) == (500, MOST_ANTS)
    steps, winners = unpacked(colony["steps"], "<u4").reshape(4, -1), unpacked(colony["winners"])
    for cycle in range(4):
        best = crowd.ways(cycle + 1)[crowd.winners[cycle]]
        assert steps[cycle, winners[cycle]] == best.moves.size


def test_forces_and_the_heuristics_favourites_are_those_of_the_map(recording: Recording) -> None:
    colony, grid = packed("pdg", recording).colony, recording.grid
    force = potential_field(grid.obstacles, grid.goal, FieldSettings()).force.reshape(-1, 2)
    strength = np.hypot(*force.T)
    (low, high), bytes_ = colony["forceScale"], unpacked(colony["force"])
    acts = strength > 0
    assert low * (high / low) ** (bytes_[acts] / 255.0) == pytest.approx(strength[acts], rel=0.04)
    angle = unpacked(colony["forceAngle"]) / 256 * 2 * np.pi
    cosine = (force[acts] * np.stack([np.cos(angle), np.sin(angle)], axis=1)[acts]).sum(axis=1) / strength[acts]
    assert cosine.min() > np.cos(2 * np.pi / 256)
    favourite = unpacked(colony["heuristic"]).reshape(grid.shape)
    assert (favourite[grid.obstacles] == 8).all()
    row, col = grid.start
    assert favourite[row, col] == recording.desirability[row, col].argmax()


def test_the_map_is_whole_if_it_is_small_and_else_what_was_seen_of_it() -> None:
    small = record("fig13", "aco", iterations=2)
    assert packed_map([packed("aco", small)])["window"] == [0, 0, 20, 20]
    obstacles = np.zeros((30, 200), dtype=bool)
    obstacles[15, 100:] = True
    large = record(obstacles, "aco", iterations=2, start=(5, 150), goal=(5, 160))
    top, left, below, beyond = packed_map([packed("aco", large)])["window"]
    assert (top, below) == (0, min(below, 30))
    assert 0 < left < 150 < 160 < beyond < 200
    seen = np.concatenate([follow((5, 150), way.moves) for cycle in (1, 2) for way in large.ways(cycle)])
    assert seen[:, 1].min() >= left
    assert seen[:, 1].max() < beyond
    assert seen[:, 0].max() < below


@pytest.mark.parametrize(
    ("values", "scale"),
    [
        ([0.0, 0.0], (1.0, 1.0)),
        ([2.0, 2.0], (2.0, 2.0)),
        ([0.0, 1e-9, 5.0], (0.005, 5.0)),
        ([4.0, 5.0], (4.0, 5.0)),
    ],
)
def test_a_scale_spans_what_is_positive(values: list[float], scale: tuple[float, float]) -> None:
    found = Scale.of(np.array(values), 1000.0)
    assert found == pytest.approx(scale)
    bytes_ = found.bytes_of(np.array(values))
    assert bytes_[0] == 0
    assert bytes_[-1] == (255 if scale[0] < scale[1] else 0)


def test_small_differences_do_not_get_the_strongest_colour() -> None:
    assert Scale.of(np.array([1.0, 1.1]), 1000.0, 3.0).bytes_of(np.array([1.1]))[0] < 30
