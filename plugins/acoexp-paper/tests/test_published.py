"""The paper's tables as they were typed out."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper import published
from acoexp_paper.audit import contradictions, decompose, differs, impossible_rows, recomputed
from acoexp_paper.published import COLUMNS


@pytest.mark.parametrize("table", [1, 2])
@pytest.mark.parametrize("algo", ["aco", "pd", "pdg"])
def test_each_block_has_ten_trials_and_their_average(table: int, algo: str) -> None:
    rows = published.rows(table, algo)
    assert len(rows) == 10
    for name in COLUMNS:
        of_rows = np.mean([row[name] for row in rows])
        misprint = 2 * 0.006 / 10 if (table, algo, name) == (2, "pd", "l1") else 0.0
        assert published.average(table, algo, name) == pytest.approx(
            of_rows - misprint, abs=0.0500001 if name[0] == "x" else 0.00006
        )


def test_the_only_average_that_is_not_that_of_its_rows_is_that_with_two_misprints() -> None:
    (row,) = (row for row in recomputed() if differs(row))
    assert (row.table, row.algo, row.column) == (2, "pd", "l1")
    assert row.of_mended == pytest.approx(row.printed, abs=0.00005)


def test_rows_that_cannot_be_are_named() -> None:
    found = list(impossible_rows())
    assert "Table 2, Standard ACO, trial 8: x1 = 6, x2 = 4, x3 = 14, but x1 <= x2 <= x3 by definition." in found
    assert sum("l1 = 35.0771" in line for line in found) == 2
    assert sum("l2 = 38.8285" in line for line in found) == 2
    assert sum("which is possible" in line for line in found) == 2
    assert len(found) == 7


def test_contradictions_are_told_with_the_numbers_of_the_tables() -> None:
    text = " ".join(contradictions())
    assert "five times in Table 2; its rows show 4" in text
    assert (
        "needs 2.2 iterations in environment 2; Table 2 gives the same algorithm 1.2 (x1), 1.4 (x2) or 1.6" in text
    )


@pytest.mark.parametrize(("length", "pair"), [(30.3848, (12, 13)), (51.1127, (20, 22)), (35.0771, None)])
def test_lengths_are_taken_apart(length: float, pair: tuple[int, int] | None) -> None:
    assert decompose(length) == pair
