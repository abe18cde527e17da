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

from acoexp import Grid, Result
from acoexp.registry.resolve import resolve
from acoexp.strategies import Diffusion
from acoexp.strategies.diffusion.none import NoDiffusion
from acoexp.tracking.mlflow.content import _git_commit, batch_metrics, trial_metrics, versions
from acoexp.trial.features import NAMES
from acoexp.trial.table import Aggregates

GRID = Grid(np.zeros((3, 3)), name="yard")
ROOT2 = math.sqrt(2.0)


class HomeMade(Diffusion):
    kernel = staticmethod(NoDiffusion.kernel)


def result(*pairs: tuple[int, int]) -> Result:
    """Return a trial whose cycles found paths of so many (straight, diagonal) moves, and lost an ant each."""
    curve_pairs = np.array(pairs, dtype=np.int32)
    return Result("aco", 0, GRID, None, None, curve_pairs, np.ones(len(pairs), dtype=np.int32), 1)


def values(metrics: Any) -> dict[str, float]:
    """Return metrics by name, without the curve."""
    listed: list[Metric] = list(metrics)
    named = {metric.key: metric.value for metric in listed if metric.key != "best_length"}
    assert len(named) == sum(metric.key != "best_length" for metric in listed)
    return named


def curve(metrics: Any) -> dict[int, float]:
    """Return the curve by cycle."""
    return {metric.step: metric.value for metric in metrics if metric.key == "best_length"}


def test_a_trial_has_its_features_its_optimum_and_its_curve_by_cycle() -> None:
    found = result((4, 0), (0, 2), (2, 1), (2, 1))
    assert values(trial_metrics(found)) == {
        "x1": 2.0, "x2": 2.0, "x3": 3.0, "l1": 2 * ROOT2, "l2": 2 + ROOT2, "optimum": 2 * ROOT2, "lost_ants": 4.0,
    }  # fmt: skip
    assert curve(trial_metrics(found)) == {1: 4.0, 2: 2 * ROOT2, 3: 2 + ROOT2, 4: 2 + ROOT2}


def test_cycles_in_which_all_ants_were_lost_have_no_point_and_no_feature_of_theirs() -> None:
    found = result((-1, -1), (0, 2), (-1, -1))
    assert set(curve(trial_metrics(found))) == {2}
    assert values(trial_metrics(found)).keys() == {"x1", "x2", "l1", "optimum", "lost_ants"}


def test_where_no_ant_ever_arrived_there_are_no_features() -> None:
    found = result((-1, -1), (-1, -1))
    assert values(trial_metrics(found)) == {"optimum": 2 * ROOT2, "lost_ants": 2.0}
    assert curve(trial_metrics(found)) == {}


def test_a_batch_has_means_and_deviations_where_there_are_any_and_the_mean_of_its_curves() -> None:
    means = {**dict.fromkeys(NAMES, 5.0), "x3": math.nan}
    summary = Aggregates(8, 1, 0.25, math.nan, means, dict.fromkeys(NAMES, 0.5))
    metrics = list(batch_metrics(summary, np.array([math.nan, 7.5]), 2, 2 * ROOT2))
    assert curve(metrics) == {2: 7.5}
    said = values(metrics)
    assert said.keys() == {
        *(name for name in NAMES if name != "x3"), *(f"{name}_sd" for name in NAMES),
        "optimum", "trials", "never_arrived", "failed", "success_rate",
    }  # fmt: skip
    assert (said["l1"], said["l1_sd"], said["optimum"]) == (5.0, 0.5, 2 * ROOT2)
    assert (said["trials"], said["never_arrived"], said["failed"], said["success_rate"]) == (8.0, 1.0, 2.0, 0.25)


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
