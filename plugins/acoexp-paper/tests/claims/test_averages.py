"""Published averages beside ours."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from acoexp_paper.claims.averages import Average, Printed, averages, averages_met, printed_averages
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.means import mean_of_ten
from acoexp_paper.trials.experiment import Experiment
from small import TRIALS

from acoexp.compare.sample import Sample
from acoexp.compare.statistics import Estimate


def one(found: Findings, *where: object) -> Average:
    """Return the average of a table, map, algorithm and column."""
    (row,) = (row for row in found.averages if row.printed[:4] == where)
    return row


def test_there_are_42_averages_and_x2_stands_for_both_of_its_readings() -> None:
    printed = list(printed_averages())
    columns = [row.column for row in printed]
    assert len(printed) - columns.count("x2_last") == 42
    assert [r.value for r in printed if r.column == "x2"] == [r.value for r in printed if r.column == "x2_last"]


@pytest.mark.parametrize(
    ("column", "value", "inside"),
    [
        ("x1", 4.95, True),
        ("x1", 4.94, False),
        ("l1", 4.99996, True),
        ("l1", 4.9999, False),
        ("l_bar", 4.9999, False),
        ("n_c", 4.99, False),
        ("n_bar", 6.05, True),
    ],
)
def test_a_printed_average_lies_inside_to_the_digits_that_are_printed(
    column: str, value: float, inside: bool
) -> None:
    assert Printed(1, "fig13", "aco", column, value).lies_in(Estimate(5.5, 5.0, 6.0)) == inside


def test_an_average_stands_beside_ours_of_all_trials_and_of_the_first_ten(
    found: Findings, experiment: Experiment
) -> None:
    x1 = experiment.main["fig13"]["pdg"].features["x1"]
    row = one(found, 1, "fig13", "pdg", "x1")
    assert row.printed.value == 2.6
    assert row.ours == mean_of_ten([x1])
    assert row.first_ten == pytest.approx(x1[:10].mean())
    on_all = [samples["pdg"].features["x1"] for samples in experiment.samples["fig13"]]
    assert row.over_maps == mean_of_ten(on_all)


def test_every_environment_is_treated_alike_its_own_map_first(found: Findings, experiment: Experiment) -> None:
    row = one(found, 3, "env1", "pf", "n_c")
    assert row.ours.value == pytest.approx(10 * experiment.main["env1"]["pf"].found.mean())
    assert row.over_maps is not None
    alone = averages({env: maps[:1] for env, maps in experiment.samples.items()})
    assert all(row.over_maps is None and row.inside_over_maps is None for row in alone)
    assert next(r.ours for r in alone if r.printed == row.printed) == row.ours


def test_what_the_search_for_the_maps_looked_at_is_marked() -> None:
    fitted = {(row.algorithm, row.column) for row in printed_averages() if row.fitted}
    assert fitted == {("aco", column) for column in ("x1", "l1", "l2", "x3")}


def test_success_is_counted_of_ten(found: Findings, experiment: Experiment) -> None:
    share = experiment.main["env2"]["pf"].found.mean()
    assert one(found, 3, "env2", "pf", "n_c").ours.value == pytest.approx(10 * share)


def test_averages_are_met_by_samples_that_are_as_the_paper_prints_them() -> None:
    printed = [row for row in printed_averages() if row.table == 1]
    of = {(row.algorithm, row.column): row.value for row in printed}
    samples = {algo: _constant(algo, of) for algo in ("aco", "pd", "pdg")}
    assert averages_met({"fig13": [samples]}) == {(1, "fig13", algo): (5, 5) for algo in samples}
    samples["pd"] = replace(samples["pd"], features={**samples["pd"].features, "x3": np.full(TRIALS, 99.0)})
    assert averages_met({"fig13": [samples]})[1, "fig13", "pd"] == (4, 5)


def _constant(algo: str, of: dict[tuple[str, str], float]) -> Sample:
    features = {name: np.full(TRIALS, of[algo, name]) for name in ("x1", "l1", "x2", "l2", "x3")}
    curves = np.full((TRIALS, 5), 30.0)
    steps = np.ones(curves.shape, dtype=np.int64)
    return Sample(algo, "fig13", 30.0, np.full(TRIALS, True), features, curves, steps)
