"""The paper's tables as they were typed out."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.published import tables
from acoexp_paper.published.tables import COLUMNS, ENVIRONMENTS, TABLE_3, TABLES, TRIALS

from acoexp.registry.load_map import load_map


@pytest.mark.parametrize("table", [1, 2])
@pytest.mark.parametrize("algo", ["aco", "pd", "pdg"])
def test_each_block_has_ten_trials_and_their_average(table: int, algo: str) -> None:
    rows = tables.rows(table, algo)
    assert len(rows) == TRIALS == 10
    for name in COLUMNS:
        of_rows = np.mean([row[name] for row in rows])
        misprint = 2 * 0.006 / 10 if (table, algo, name) == (2, "pd", "l1") else 0.0
        assert tables.average(table, algo, name) == pytest.approx(
            of_rows - misprint, abs=0.0500001 if name[0] == "x" else 0.00006
        )


def test_a_column_is_that_of_the_rows_in_their_order() -> None:
    assert tables.column(1, "aco", "x1")[:4].tolist() == [10, 14, 7, 15]


@pytest.mark.parametrize("env", TABLE_3.environments)
@pytest.mark.parametrize("algo", TABLE_3.algos)
def test_in_table_3_all_trials_converge_to_the_published_optimum(env: str, algo: str) -> None:
    assert tables.performance(env, algo, "n_c") == TRIALS
    assert tables.performance(env, algo, "l_bar") == round(ENVIRONMENTS[env].optimum, 4)


@pytest.mark.parametrize("env", ENVIRONMENTS)
def test_the_published_optimum_is_that_of_the_built_in_map(env: str) -> None:
    assert load_map(env).optimum_pair == ENVIRONMENTS[env].optimum_pair


def test_nothing_but_the_optimum_is_known_of_the_environment_without_a_table_of_its_own() -> None:
    assert {
        env for env, known in ENVIRONMENTS.items() if known.only_optimum
    } == ENVIRONMENTS.keys() - TABLES.values()
