"""The sections on method and audit."""

from __future__ import annotations

from acoexp_paper.page.method import audit, method
from acoexp_paper.published.audit import impossible_rows
from acoexp_paper.trials.experiment import Experiment
from small import OWN


def test_the_settings_are_those_that_were_run(experiment: Experiment) -> None:
    text = method(experiment)[0].text
    assert f"rho = 0.5, {OWN['ants']} ants, {OWN['iterations']} cycles" in text


def test_the_audit_names_the_one_average_that_differs_and_every_impossible_row() -> None:
    numbers, _, rows, *_ = audit()
    assert [row[1:3] for row in numbers.table.rows if row[-1] == "differs"] == [["ACO-PD", "l1"]]
    assert rows.items == list(impossible_rows())
