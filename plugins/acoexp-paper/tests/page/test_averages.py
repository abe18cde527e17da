"""The paper's tables with our trials, and the averages beside ours."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from acoexp_paper.claims.findings import Findings
from acoexp_paper.page.averages import averages, trial_tables
from acoexp_paper.page.document import Document, Section, tables_in
from acoexp_paper.published.tables import COLUMNS
from acoexp_paper.trials.experiment import Experiment

from acoexp.report.table import Table


def trial_table(experiment: Experiment, name: str) -> Table:
    return tables_in(Document("", "", [Section("", trial_tables(experiment))]))[name]


def test_table_1_has_the_ten_trials_of_each_algorithm_and_their_average(experiment: Experiment) -> None:
    table = trial_table(experiment, "table1")
    assert table.headings == [
        "Algorithm",
        "Trial",
        *(f"{whose} {name}" for whose in ("ours", "paper") for name in COLUMNS),
    ]
    blocks = [[row[0] for row in table.rows[first : first + 11]] for first in (0, 11, 22)]
    assert blocks == [[name, *[""] * 9, "Average result"] for name in ("Standard ACO", "ACO-PD", "ACO-PDG")]
    x1 = experiment.main["fig13"]["pd"].features["x1"][:10]
    of_pd = table.rows[11:22]
    assert [row[1:3] for row in of_pd[:10]] == [[str(trial), f"{value:.0f}"] for trial, value in enumerate(x1, 1)]
    assert of_pd[10][:3] == ["Average result", "", f"{x1.mean():.1f}"]
    assert of_pd[3][7:] == ["8", "30.3848", "8", "30.3848", "8"]  # as printed
    assert of_pd[10][7:] == ["7.9", "30.3848", "11.6", "31.7505", "14.2"]


def test_table_3_counts_and_averages_ten_trials(experiment: Experiment) -> None:
    table = trial_table(experiment, "table3")
    assert [row[:2] for row in table.rows] == [
        ["ACO-PF", "ours"], ["", "paper"], ["ACO-PDG", "ours"], ["", "paper"],
    ]  # fmt: skip
    assert table.rows[1][2:] == ["10", "32.1421", "11.0", "10", "35.0711", "12.0"]
    of_pf = dict(zip(table.headings, table.rows[0], strict=True))
    sample = experiment.main["env2"]["pf"]
    found = sample.found[:10]
    assert of_pf["env2 n_c"] == str(found.sum())
    assert of_pf["env2 l"] == f"{sample.features['l2'][:10].mean():.4f}"
    assert of_pf["env2 n"] == f"{np.mean(sample.features['x1'][:10][found]):.1f}"


def test_a_table_says_whether_its_map_is_the_true_one(experiment: Experiment) -> None:
    given = replace(experiment, given=frozenset({"fig13"}))
    assert "on the map given for the environment of Fig. 13" in trial_table(given, "table1").note
    assert "on our reconstruction of the environment of Fig. 13" in trial_table(experiment, "table1").note


def test_each_average_has_its_row(found: Findings) -> None:
    (block,) = averages(found)
    first = block.table.rows[0]
    row = found.averages[0]
    assert len(block.table.rows) == len(found.averages)
    assert first[:5] == ["1", "fig13", "Standard ACO", "x1 *", "11.0"]
    assert first[5] == f"{row.first_ten:.1f}"
    assert first[6] == "{:.1f} [{:.1f}, {:.1f}]".format(*row.ours)
    assert first[7] == ("yes" if row.inside else "no")


def test_without_an_ensemble_its_columns_have_dashes(found: Findings) -> None:
    alone = found._replace(averages=[row._replace(over_maps=None) for row in found.averages])
    (block,) = averages(alone)
    assert {tuple(row[8:]) for row in block.table.rows} == {("-", "-")}
