"""Readings of the paper: what each changes, and which trials it needs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from acoexp_paper.published.tables import ENVIRONMENTS
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.readings import DEFAULT, ENVS, READINGS, Reading, samples_of_readings, trials_of_readings
from made import made_trials
from small import ENSEMBLE_TRIALS, context

from acoexp.grid.grid import Grid
from acoexp.registry.resolve import resolve
from acoexp.trial.seeds import Seeds
from acoexp.trial.settings import Settings
from acoexp.trial.trials import Trials


@pytest.mark.parametrize("reading", [r for r in READINGS if r is not DEFAULT], ids=lambda reading: reading.text)
def test_each_reading_changes_the_keys_that_it_names(reading: Reading) -> None:
    defaults, changed = resolve("pdg", {}).as_dict(), resolve("pdg", reading.of("pdg")).as_dict()
    keys = {key.partition("=")[0].partition(".")[0] for key in reading.text.split()}
    assert {key for key in defaults if defaults[key] != changed[key] and key != "algo"} == keys


def test_no_two_readings_are_one() -> None:
    assert len({reading.text for reading in READINGS}) == len(READINGS) == 18


def test_what_is_of_the_diffusion_changes_nothing_for_standard_aco() -> None:
    reading = Reading("", {"q": 100.0, "diffusion": {"source": "sum_in"}, "field": {"reach": 2.0}})
    assert reading.of("aco") == {"q": 100.0}
    assert reading.of("pd") == reading.values


def test_what_a_reading_does_not_change_keeps_its_first_trials(experiment: Experiment) -> None:
    (default, by_default), (_, by_nearest) = samples_of_readings(experiment)
    assert default is DEFAULT
    main = experiment.main["fig13"]
    for algo, kept in by_default["fig13"].items():
        np.testing.assert_array_equal(kept.curves, main[algo].curves[:ENSEMBLE_TRIALS])
    np.testing.assert_array_equal(by_nearest["fig13"]["aco"].curves, main["aco"].curves[:ENSEMBLE_TRIALS])


def test_their_number_of_trials_is_what_they_ask_for(experiment: Experiment, tmp_path: Path) -> None:
    asked = []

    def trials_of(settings: Settings, grid: Grid, seeds: Seeds, show: Callable[[int], None]) -> Trials:
        asked.append((settings.field.obstacles, len(seeds)))
        return made_trials(settings, grid, seeds, show)

    counted = replace(experiment, context=context(tmp_path, trials_of))
    counted.main  # noqa: B018 (run before, and not for the readings)
    asked.clear()
    samples_of_readings(counted)
    assert set(asked) == {("nearest", ENSEMBLE_TRIALS)}
    assert len(asked) == sum(algo != "aco" for env in ENVS for algo in ENVIRONMENTS[env].algos)
    assert trials_of_readings(counted) == sum(trials for _, trials in asked)
