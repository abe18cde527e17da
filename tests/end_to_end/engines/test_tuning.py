"""Optuna through Hydra's sweeper: a study's objective is what its jobs return, for a batch the mean."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import yaml
from running import refusal, run_acoexp, trials

pytestmark = pytest.mark.slow_without_jit


def study(home: Path, *arguments: str) -> dict[str, Any]:
    """Run a small study; return what Optuna says was best."""
    pytest.importorskip("hydra_plugins.hydra_optuna_sweeper")
    sweeper = ("hydra/sweeper=optuna", "hydra.sweeper.n_trials=4", "hydra.sweeper.sampler.seed=1")
    ended = run_acoexp("-m", *sweeper, *arguments, "iterations=4", "ants=9", "tracking=none", cwd=home)
    assert ended.returncode == 0, ended.stderr
    (file,) = home.rglob("optimization_results.yaml")
    best: dict[str, Any] = yaml.safe_load(file.read_text(encoding="utf-8"))
    return best


def test_the_objective_of_a_trial_is_its_best_length(tmp_path: Path) -> None:
    best = study(tmp_path, "rho=interval(0.1,0.9)", "algo=choice(aco,pdg)")
    found = {trial["config"]["rho"]: trial for trial in trials(tmp_path)}
    assert len(found) == 4
    assert best["best_value"] == min(trial["l1"] for trial in found.values())
    trial = found[str(best["best_params"]["rho"])]
    assert (trial["algo"], trial["l1"]) == (best["best_params"]["algo"], best["best_value"])


def test_a_database_for_the_study_is_refused_before_anything_runs(tmp_path: Path) -> None:
    pytest.importorskip("hydra_plugins.hydra_optuna_sweeper")
    storage = "hydra.sweeper.storage=sqlite:///study.db"
    said = refusal("-m", "hydra/sweeper=optuna", storage, "rho=interval(0.1,0.9)", "tracking=none", cwd=tmp_path)
    assert said.startswith("hydra.sweeper.storage: expected nothing")


def test_the_objective_of_a_batch_is_the_mean_over_its_seeds(tmp_path: Path) -> None:
    best = study(tmp_path, "rho=interval(0.1,0.9)", "seeds=0-9")
    batches = [json.loads(file.read_text(encoding="utf-8")) for file in tmp_path.rglob("batch.json")]
    means = {batch["config"]["rho"]: batch["means"]["l1"] for batch in batches}
    assert len(means) == 4
    assert best["best_value"] == pytest.approx(min(means.values()), rel=1e-12)
    assert means[str(best["best_params"]["rho"])] == min(means.values())
