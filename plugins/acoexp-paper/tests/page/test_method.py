"""The sections on maps, method and audit."""

from __future__ import annotations

from dataclasses import replace

from acoexp_paper.page.document import Bullets
from acoexp_paper.page.method import audit, method
from acoexp_paper.published.audit import impossible_rows
from acoexp_paper.trials.experiment import Experiment
from small import ENSEMBLE_TRIALS, MAPS, OWN

from acoexp.grid.grid import Grid


def test_the_settings_are_those_that_were_run(experiment: Experiment) -> None:
    text = method(experiment)[0].text
    assert f"rho = 0.5, {OWN['ants']} ants, {OWN['iterations']} cycles" in text
    assert f"other readings: {ENSEMBLE_TRIALS} trials each" in text


def test_each_map_stands_with_its_source_optimum_and_further_maps(experiment: Experiment) -> None:
    given = replace(experiment, given=frozenset({"fig13"}))
    rows = {row[0]: row for row in method(given)[1].table.rows}
    digest = experiment.maps["fig13"].digest
    assert rows["fig13"][2:] == ["given", experiment.maps["fig13"].moves, "30.3848", digest, "0"]
    assert rows["env1"][1:3] + rows["env1"][-1:] == ["environment 1 of Table 3", "reconstruction", str(MAPS)]


def test_the_fit_of_a_map_is_said_where_it_is_known(experiment: Experiment) -> None:
    fits = [f"{env}: {grid.metadata['fit']}" for env, grid in experiment.maps.items() if "fit" in grid.metadata]
    assert fits
    assert method(experiment)[2] == Bullets(fits)
    unfitted = {"fig13": Grid(experiment.maps["fig13"].obstacles)}
    assert len(method(replace(experiment, maps=unfitted))) == 2


def test_the_audit_names_the_one_average_that_differs_and_every_impossible_row() -> None:
    numbers, _, rows, *_ = audit()
    assert [row[1:3] for row in numbers.table.rows if row[-1] == "differs"] == [["ACO-PD", "l1"]]
    assert rows.items == list(impossible_rows())
