"""Which trials the experiment asks for, on trials that are made up."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from acoexp_paper.published.tables import ENVIRONMENTS
from acoexp_paper.trials.concentration import ENTROPY
from acoexp_paper.trials.experiment import Experiment
from made import made_trials, make_up
from small import ENSEMBLE_TRIALS, MAPS, OWN, TRIALS, context

from acoexp.grid.grid import Grid
from acoexp.registry.resolve import resolve
from acoexp.trial.seeds import Seeds
from acoexp.trial.settings import Settings
from acoexp.trial.trials import Trials


@pytest.fixture
def asked() -> Counter[tuple[str, str, int]]:
    """What was asked for: algorithm, map, and number of trials."""
    return Counter()


@pytest.fixture
def counted(
    experiment: Experiment,
    asked: Counter[tuple[str, str, int]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> Experiment:
    """The small experiment, which counts what it asks for."""
    make_up(monkeypatch)

    def trials_of(settings: Settings, grid: Grid, seeds: Seeds, show: Callable[[int], None]) -> Trials:
        asked[settings.label, grid.name, len(seeds)] += 1
        return made_trials(settings, grid, seeds, show)

    return replace(experiment, context=context(tmp_path, trials_of))


def test_each_algorithm_runs_once_on_each_map_of_its_environment(
    counted: Experiment, asked: Counter[tuple[str, str, int]]
) -> None:
    for _ in range(2):
        assert {env: set(samples) for env, samples in counted.main.items()} == {
            env: set(known.algos) for env, known in ENVIRONMENTS.items()
        }
        assert {len(maps) for maps in counted.samples.values()} == {1 + MAPS}
    assert set(asked.values()) == {1}
    assert asked["pf", "env1", TRIALS] == asked["pf", "env1-00", ENSEMBLE_TRIALS] == 1


def test_its_size_is_the_number_of_trials_that_it_asks_for(
    counted: Experiment, asked: Counter[tuple[str, str, int]]
) -> None:
    assert counted.main
    assert counted.samples
    assert counted.size == sum(trials for _, _, trials in asked.elements())


def test_no_further_map_counts_where_the_true_one_is_given(experiment: Experiment) -> None:
    given = replace(experiment, given=frozenset({"fig13"}))
    assert given.further_maps("fig13") == []
    assert len(given.further_maps("env2")) == MAPS


def test_without_trials_for_them_there_are_no_further_maps(experiment: Experiment) -> None:
    alone = replace(experiment, ensemble_trials=0)
    assert [alone.maps_of(env) for env in ENVIRONMENTS] == [[grid] for grid in alone.maps.values()]


def test_the_environments_own_map_comes_first_with_the_same_trials(experiment: Experiment) -> None:
    for env, maps in experiment.samples.items():
        assert maps[0] is experiment.main[env]
        assert [grid.name for grid in experiment.maps_of(env)] == [next(iter(of.values())).map for of in maps]


def test_pheromone_is_looked_at_where_the_paper_shows_it(experiment: Experiment) -> None:
    shows = {env: ENTROPY in samples["pdg"].features for env, samples in experiment.main.items()}
    assert shows == {"fig13": True, "env1": False, "env2": False}


def test_the_command_lines_settings_hold_unless_a_reading_says_otherwise(
    experiment: Experiment, tmp_path: Path
) -> None:
    own = resolve("pdg", {**OWN, "field": {"repulsion": 7.0, "reach": 3.0}})
    with_field = replace(experiment, context=replace(context(tmp_path), settings=own))
    settings = with_field.settings("pd", {"field": {"repulsion": 5.0}, "ants": 9})
    assert (settings.label, settings.scalars.iterations, settings.scalars.ants) == ("pd", OWN["iterations"], 9)
    assert (settings.field.repulsion, settings.field.reach) == (5.0, 3.0)


def test_lost_ants_are_the_mean_of_each_cycle(experiment: Experiment) -> None:
    lost = experiment.lost_per_cycle("fig13")["pd"]
    assert lost.shape == (OWN["iterations"],)
    assert lost.sum() == pytest.approx(experiment.main["fig13"]["pd"].features["lost_ants"].mean())
    assert np.unique(lost * TRIALS % 1).size == 1


def test_a_batch_is_shown_by_its_algorithm_and_map(experiment: Experiment, tmp_path: Path) -> None:
    shown: dict[str, int] = {}
    watched = replace(context(tmp_path, made_trials), show=shown.__setitem__)
    with pytest.MonkeyPatch.context() as patch:
        make_up(patch)
        assert replace(experiment, context=watched).main
    assert shown["pf on env2"] == TRIALS


@pytest.mark.slow_without_jit
def test_trials_that_are_not_kept_are_those_that_would_be(experiment: Experiment, tmp_path: Path) -> None:
    shown: dict[str, int] = {}
    kept = replace(experiment, context=replace(context(tmp_path), show=shown.__setitem__), trials=3)
    grids = kept.maps_of("fig13")
    samples = kept.unkept("fig13", kept.settings("pd", {}), grids, 3, "again")
    assert [sample.map for sample in samples] == [grid.name for grid in grids]
    for name, values in kept.main["fig13"]["pd"].features.items():
        np.testing.assert_array_equal(samples[0].features[name], values)
    assert shown["pd on fig13, again"] == 3 * len(grids)
