"""What a run carries: its path, and its picture where one is drawn."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from running import listing

from acoexp import Result, solve
from acoexp.command.results import pictures
from acoexp.command.results.artifacts import carried, pictured
from acoexp.command.results.paths import write_path


@pytest.fixture(scope="module")
def result() -> Result:
    """Return a short trial."""
    return solve("fig13", "aco", 0, iterations=3)


def test_it_carries_the_path_that_a_trial_alone_writes(result: Result, tmp_path: Path) -> None:
    write_path(result, tmp_path)
    assert carried(result) == {"path.csv": (tmp_path / "path.csv").read_bytes()}


def test_the_pictures_are_in_the_folder_and_the_one_of_the_path_is_carried(result: Result, tmp_path: Path) -> None:
    artifacts = pictured(tmp_path, result)
    assert listing(tmp_path) == {"path.png", "convergence.png"}
    assert artifacts == {**carried(result), "path.png": (tmp_path / "path.png").read_bytes()}


def test_a_picture_that_cannot_be_drawn_is_a_warning_and_the_one_there_is_not_taken_for_it(
    result: Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "path.png").write_bytes(b"of another trial")
    monkeypatch.setattr(pictures, "draw_map", lambda *_: 1 / 0)
    assert pictured(tmp_path, result) == carried(result)
    assert caplog.messages == ["the pictures could not be drawn: ZeroDivisionError: division by zero"]


def test_where_no_ant_arrived_there_is_no_path() -> None:
    lost = Result(
        *("aco", 0, solve("fig13", "aco", 0, iterations=1).grid, None, None),
        curve_pairs=np.full((2, 2), -1, np.int32),
        lost_ants=np.ones(2, np.int32),
        cycle_steps=np.full(2, 2),
    )
    assert carried(lost) == {}
