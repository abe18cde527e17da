"""Readings of the paper: what each changes, on which maps, and which trials it needs."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.readings import (
    ENVS,
    READINGS,
    SOURCES,
    SUM_IN,
    TAU0,
    UNDIRECTED,
    Reading,
    samples_of_readings,
    trials_of_readings,
)
from made import made_unkept, make_up
from small import MAPS, READING_TRIALS

from acoexp.compare.sample import Sample
from acoexp.grid.grid import Grid
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.trial.settings import Settings

WITH_KEYS = [
    reading for reading in READINGS if "=" in reading.text and not reading.undirected and not reading.moves
]


@pytest.mark.parametrize("reading", WITH_KEYS, ids=lambda reading: reading.text)
def test_each_reading_changes_the_keys_that_it_names(reading: Reading) -> None:
    defaults, changed = resolve("pdg", {}).as_dict(), resolve("pdg", reading.of("pdg")).as_dict()
    keys = {key.partition("=")[0].partition(".")[0] for key in reading.text.split()}
    assert {key for key in defaults if defaults[key] != changed[key] and key != "algo"} == keys


def test_no_two_readings_are_one() -> None:
    assert len({reading.text for reading in READINGS}) == len(READINGS)


def test_the_sources_are_all_but_the_default() -> None:
    sources = {reading.values["diffusion"]["source"] for reading in SOURCES}
    assert sources == {"walked_edge", "sum_in", "mean_out", "max_out"}


def test_what_is_of_the_diffusion_changes_nothing_for_standard_aco() -> None:
    reading = Reading("", {"q": 100.0, "diffusion": {"source": "sum_in"}, "field": {"reach": 2.0}})
    assert reading.of("aco") == {"q": 100.0}
    assert reading.of("pd") == reading.values
    assert not SUM_IN.changes("aco", load_map("fig13"))


def test_undirected_deposit_is_another_update_for_each_algorithm() -> None:
    names = {algo: resolve(algo, UNDIRECTED.of(algo)).chosen["update"].name for algo in ("aco", "pd", "pdg")}
    assert names == {"aco": "UndirectedAntCycle", "pd": "UndirectedAntCycle", "pdg": "UndirectedDualAntCycle"}


def test_two_readings_together_change_what_both_do() -> None:
    both = SUM_IN + UNDIRECTED
    assert both.text == "diffusion.source=sum_in undirected deposit"
    assert both.of("pd").keys() == {"diffusion", "update"}
    assert (SUM_IN + TAU0).of("aco") == {"tau0": 8.0}


def test_a_rule_for_diagonals_fits_the_maps_that_keep_their_optimum() -> None:
    room = Grid(np.zeros((4, 4)), moves="no_cut")
    assert Reading("", {}, moves="no_cut").on(room) is room
    free = Reading("", {}, moves="free")
    changed = free.on(room)
    assert changed is not None
    assert changed.moves == "free"
    assert free.changes("aco", room)
    corner = Grid(np.array([[0, 0], [1, 0]]), moves="no_cut")
    assert free.on(corner) is None


def test_what_a_reading_does_not_change_keeps_its_first_trials(
    experiment: Experiment, monkeypatch: pytest.MonkeyPatch
) -> None:
    make_up(monkeypatch)
    ((reading, by_nearest, default),) = samples_of_readings(experiment)
    assert reading.text == "field.obstacles=nearest"
    for env in ENVS:
        for place, samples in enumerate(experiment.samples[env]):
            kept, nearest = default[env][place], by_nearest[env][place]
            assert nearest is not None
            assert nearest["aco"] is kept["aco"]
            assert kept["pdg"].curves.tolist() == samples["pdg"].curves[:READING_TRIALS].tolist()


def test_their_number_of_trials_is_what_they_ask_for(
    experiment: Experiment, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = []

    def unkept(
        self: Experiment, env: str, settings: Settings, grids: list[Grid], trials: int, text: str
    ) -> list[Sample]:
        asked.append((settings.field.obstacles, trials * len(grids)))
        return made_unkept(self, env, settings, grids, trials, text)

    make_up(monkeypatch)
    monkeypatch.setattr(Experiment, "unkept", unkept)
    assert len(list(samples_of_readings(experiment))) == 1
    assert asked == [("nearest", READING_TRIALS * (1 + MAPS))] * 2 * len(ENVS)
    assert trials_of_readings(experiment) == sum(trials for _, trials in asked)
