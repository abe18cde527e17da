"""The command's searches: by standard ACO as everyone else runs it, one file a seed; they end together."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from acoexp import AcoexpError, Grid, solve_many
from acoexp.reconstruct.calibration import Calibration, standard_aco
from acoexp.reconstruct.layout import paint
from acoexp.reconstruct.published import RULES

MAPS = [paint(np.array(rectangles)) for rectangles in ([[2, 2, 9, 12], [11, 9, 17, 18]], [[4, 0, 6, 12]])]


@pytest.mark.slow_without_jit
@pytest.mark.parametrize("moves", RULES)
def test_trials_are_those_of_aco_whatever_map_was_before(moves: str) -> None:
    aco = standard_aco(20)
    for obstacles in (*MAPS, MAPS[0]):
        grid = Grid(obstacles, moves=moves)
        found = aco.on(grid).trials(range(5))
        expected = solve_many(grid, algo="aco", seeds=range(5), iterations=20)
        assert [r.curve_pairs.tolist() for r in found] == [r.curve_pairs.tolist() for r in expected]


def test_each_seed_has_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Calibration, "search", lambda self, seed, progress: f"found from {seed}")
    files = Calibration(env="env1", seed=8, runs=2, out=str(tmp_path)).run()
    assert [file.name for file in files] == ["env1-08.txt", "env1-09.txt"]
    assert [file.read_text() for file in files] == ["found from 8", "found from 9"]


def test_when_a_search_fails_the_others_end_at_their_next_candidate(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun, told = threading.Event(), threading.Event()

    def search(self: Calibration, seed: int, progress: Callable[[], None]) -> str:
        if seed == 0:
            begun.wait(60)
            raise AcoexpError("failed")
        begun.set()
        try:
            for _ in range(1000):
                progress()
                time.sleep(0.001)
        except AcoexpError:
            told.set()
        return ""

    monkeypatch.setattr(Calibration, "search", search)
    with pytest.raises(AcoexpError, match="failed"):
        Calibration(runs=2, threads=2, out=str(tmp_path)).run()
    assert told.is_set()
    assert list(tmp_path.iterdir()) == []
