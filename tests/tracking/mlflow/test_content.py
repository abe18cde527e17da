"""What a run says besides its parameters: metrics where they are defined, and tags."""

from __future__ import annotations

import math
import subprocess
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mlflow.entities import Metric

from acoexp import Grid, Result, StrategyError
from acoexp.grid.frame import Frame
from acoexp.registry.resolve import resolve
from acoexp.strategies import Diffusion
from acoexp.strategies.diffusion.none import NoDiffusion
from acoexp.tracking.mlflow.content import (
    _git_commit,
    batch_metrics,
    description,
    trial_metrics,
    versions,
)
from acoexp.trial.features import NAMES
from acoexp.trial.outcome import Batch, Failure
from acoexp.trial.table import TABLE

GRID = Grid(np.zeros((3, 3)), name="yard")
CURVES = ("cycle_length", "best_length")
ROOT2 = math.sqrt(2.0)


class HomeMade(Diffusion):
    kernel = staticmethod(NoDiffusion.kernel)


def result(*pairs: tuple[int, int]) -> Result:
    """Return a trial whose cycles found paths of so many (straight, diagonal) moves, and lost an ant each."""
    curve_pairs = np.array(pairs, dtype=np.int32)
    arrives = np.array([7, 7], dtype=np.uint8) if max(pairs) > (-1, -1) else None
    lost, steps = np.ones(len(pairs), dtype=np.int32), np.eye(1, len(pairs), dtype=np.int64)[0]
    return Result("aco", 0, GRID, arrives, None, curve_pairs, lost, steps)


def values(metrics: Any) -> dict[str, float]:
    """Return metrics by name, without the curve."""
    listed: list[Metric] = list(metrics)
    named = {metric.key: metric.value for metric in listed if metric.key not in CURVES}
    assert len(named) == sum(metric.key not in CURVES for metric in listed)
    return named


def curve(metrics: Any, name: str = "cycle_length") -> dict[int, float]:
    """Return a curve by cycle."""
    return {metric.step: metric.value for metric in metrics if metric.key == name}


def test_a_trial_has_its_features_its_optimum_and_its_curve_by_cycle() -> None:
    found = result((4, 0), (0, 2), (2, 1), (2, 1))
    assert values(trial_metrics(found, seconds=0.5)) == {
        "x1": 2.0, "x2": 2.0, "x3": 3.0, "l1": 2 * ROOT2, "l2": 2 + ROOT2, "optimum": 2 * ROOT2, "lost_ants": 4.0,
        "turns": 0.0, "turning": 0.0, "detour": pytest.approx(1.0), "any_angle_optimum": pytest.approx(2 * ROOT2),
        "cycles": 4.0, "ant_steps": 1.0, "seconds": 0.5,
    }  # fmt: skip
    assert curve(trial_metrics(found)) == {1: 4.0, 2: 2 * ROOT2, 3: 2 + ROOT2, 4: 2 + ROOT2}
    assert curve(trial_metrics(found), "best_length") == {1: 4.0, 2: 2 * ROOT2, 4: 2 * ROOT2}


def test_on_a_map_in_metres_clearances_are_in_metres_too() -> None:
    walled = Grid([[0, 0, 0], [0, 0, 0], [1, 0, 0]], goal=(0, 2), frame=Frame(rows=3, resolution=0.05))
    moves = np.zeros(2, dtype=np.uint8)
    curve_pairs = np.array([[2, 0]], dtype=np.int32)
    said = values(
        trial_metrics(Result("aco", 0, walled, moves, None, curve_pairs, np.zeros(1, np.int32), np.full(1, 2)))
    )
    assert (said["clearance_least"], said["clearance_least_m"]) == (2.0, 0.1)
    assert said["clearance_mean_m"] == pytest.approx(0.05 * (2 + math.sqrt(5) + math.sqrt(8)) / 3)


def test_cycles_in_which_all_ants_were_lost_have_no_point_and_no_feature_of_theirs() -> None:
    found = result((-1, -1), (0, 2), (-1, -1))
    assert set(curve(trial_metrics(found))) == {2}
    assert curve(trial_metrics(found), "best_length") == {2: 2 * ROOT2, 3: 2 * ROOT2}
    assert not {"x3", "l2"} & values(trial_metrics(found)).keys()


def test_where_no_ant_ever_arrived_there_are_no_features() -> None:
    found = result((-1, -1), (-1, -1))
    assert values(trial_metrics(found)) == {
        "optimum": 2 * ROOT2, "any_angle_optimum": pytest.approx(2 * ROOT2),
        "cycles": 2.0, "lost_ants": 2.0, "ant_steps": 1.0,
    }  # fmt: skip
    assert curve(trial_metrics(found)) == {}


def test_a_batch_has_means_and_deviations_where_there_are_any_and_the_means_of_its_curves() -> None:
    table = np.zeros(8, TABLE)
    table["x1"], table["x2"], table["l1"], table["l2"], table["cycles"] = 2, 4, [2 * ROOT2] * 2 + [5.0] * 6, 5.0, 9
    failures = [Failure(9, StrategyError("the part broke"))] * 2
    batch = Batch(table, np.array([math.nan, 7.5]), np.array([8.0, 7.0]), failures, ran=4, seconds=2.0)
    metrics = list(batch_metrics(batch, GRID))
    assert curve(metrics) == {2: 7.5}
    assert curve(metrics, "best_length") == {1: 8.0, 2: 7.0}
    said = values(metrics)
    assert said.keys() == {
        *(name for name in NAMES if name != "x3"), *(f"{name}_sd" for name in NAMES if name != "x3"),
        "optimum", "any_angle_optimum", "trials", "never_arrived", "failed", "success_rate", "expected_cycles",
        "seconds",
    }  # fmt: skip
    assert (said["x1"], said["l2"], said["l2_sd"], said["optimum"]) == (2.0, 5.0, 0.0, 2 * ROOT2)
    assert (said["trials"], said["never_arrived"], said["failed"], said["success_rate"]) == (8.0, 0.0, 2.0, 0.25)
    assert (said["expected_cycles"], said["seconds"]) == ((2 * 2 + 6 * 9) / 2, 0.5)


def test_its_description_tells_map_algorithm_and_the_command() -> None:
    said = description(resolve("aco", {}), GRID, "python -m acoexp algo=aco seed=3", "seed 3")
    assert said.startswith("aco on yard, seed 3\n\nMap: yard, 3 x 3 cells, moves no_squeeze, exact optimum 2.8284")
    assert "Algorithm: aco: heuristic goal_distance, choice roulette" in said
    assert said.endswith("\n\n    python -m acoexp algo=aco seed=3")
    assert "command" not in description(resolve("aco", {}), GRID, None, "seed 3")


def test_its_tags_say_by_which_packages() -> None:
    tags = versions(resolve("aco", {"diffusion": HomeMade()}).packages)
    ours = f"acoexp {version('acoexp')}"
    assert tags["acoexp.version"] == version("acoexp")
    assert {key: value for key, value in tags.items() if key.endswith(".package")} == {
        "heuristic.package": ours, "choice.package": ours, "post.package": ours, "update.package": ours,
    }  # fmt: skip


def test_the_commit_of_a_working_directory_in_a_repository_is_a_tag(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def git(*args: str) -> str:
        command = ["git", "-c", "user.name=x", "-c", "user.email=x@x", *args]
        return subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True).stdout.strip()

    git("init", "-q")
    git("commit", "-q", "--allow-empty", "-m", "x")
    monkeypatch.chdir(tmp_path)
    _git_commit.cache_clear()
    try:
        tags = versions({})
        assert tags["mlflow.source.git.commit"] == git("rev-parse", "HEAD")
    finally:
        _git_commit.cache_clear()
