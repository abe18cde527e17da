"""``tracking=none``: a tracker that keeps nothing, and is in nobody's way."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from acoexp import Grid, solve
from acoexp.registry.resolve import resolve
from acoexp.tracking.setup import Setup, Trial
from acoexp.tracking.tracker import NoTracker
from acoexp.trial.outcome import Batch
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.table import TABLE
from acoexp.trial.trials import Trials

SEEDS = parse_seeds("0-9")


@pytest.fixture
def tracker(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> NoTracker:
    """Return a tracker, in an empty folder."""
    monkeypatch.chdir(tmp_path)
    return NoTracker()


def test_it_touches_nothing_and_finds_nothing(tracker: NoTracker, tmp_path: Path) -> None:
    tracker.check()
    tracker.prepare()
    assert (tracker.find("c", {"i"}), tracker.has("i"), [*tracker.find_trials("c", SEEDS)]) == ({}, False, [])
    assert list(tmp_path.iterdir()) == []


def test_what_it_was_given_it_has_not(tracker: NoTracker, tmp_path: Path) -> None:
    grid = Grid(((0, 0), (0, 0)))
    setup, result = Setup.of(resolve("aco", {}), grid), solve(grid, "aco", 0, iterations=1, ants=1)
    trial = Trial(setup, result)
    tracker.log(trial)
    tracker.log_failure(setup, 1, "the part broke")
    log = tracker.begin(setup, SEEDS)
    log.keep(Trials.of([result]))
    log.finish(Batch(np.zeros(0, TABLE), np.zeros(1), np.zeros(1), [], 0, 0.0), {"path.csv": b"x"})
    log.abandon("enough")
    assert not tracker.has(trial.identity)
    assert not tracker.has(setup.identity(SEEDS))
    assert not tracker.has_all([trial.identity])
    assert list(tmp_path.iterdir()) == []


def test_a_worker_needs_no_address_of_it(tracker: NoTracker) -> None:
    assert (tracker.address, tracker.where) == (None, "not tracked")
