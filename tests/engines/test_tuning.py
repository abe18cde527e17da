"""Optuna through Hydra's sweeper: a study's objective is what its trials found."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from running import run_acoexp, trials


@pytest.mark.slow_without_jit
def test_a_study_minimises_the_length(tmp_path: Path) -> None:
    pytest.importorskip("hydra_plugins.hydra_optuna_sweeper")
    study = ("hydra/sweeper=optuna", "hydra.sweeper.n_trials=5", "hydra.sweeper.sampler.seed=1")
    space = ("rho=interval(0.1,0.9)", "algo=choice(aco,pdg)")
    ended = run_acoexp("-m", *study, *space, "iterations=4", "ants=3", "tracking=none", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert "5 trials finished" in ended.stdout
    (file,) = tmp_path.rglob("optimization_results.yaml")
    best = yaml.safe_load(file.read_text(encoding="utf-8"))
    found = {trial["config"]["rho"]: trial for trial in trials(tmp_path)}
    assert best["best_value"] == min(trial["l1"] for trial in found.values() if trial["l1"] is not None)
    trial = found[str(best["best_params"]["rho"])]
    assert (trial["algo"], trial["l1"]) == (best["best_params"]["algo"], best["best_value"])
