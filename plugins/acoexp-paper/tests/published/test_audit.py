"""What in the paper's tables cannot be, found from the tables alone."""

from __future__ import annotations

import pytest
from acoexp_paper.published.audit import EQUATIONS, contradictions, decompose, impossible_rows, recomputed


def test_the_only_average_that_is_not_that_of_its_rows_is_that_with_two_misprints() -> None:
    (row,) = (row for row in recomputed() if row.differs)
    assert (row.table, row.algo, row.column) == (2, "pd", "l1")
    assert row.of_mended == pytest.approx(row.printed, abs=0.00005)


def test_every_average_of_tables_1_and_2_is_recomputed() -> None:
    assert len({row[:3] for row in recomputed()}) == 2 * 3 * 5


def test_rows_that_cannot_be_are_named() -> None:
    found = list(impossible_rows())
    assert "Table 2, Standard ACO, trial 8: x1 = 6, x2 = 4, x3 = 14, but x1 <= x2 <= x3 by definition." in found
    assert sum("l1 = 35.0771" in line for line in found) == 2
    assert sum("l2 = 38.8285" in line for line in found) == 2
    assert sum("which is possible" in line for line in found) == 2
    assert len(found) == 7


def test_contradictions_are_described_with_the_numbers_of_the_tables() -> None:
    text = " ".join(contradictions())
    assert "five times in Table 2; its rows show 4" in text
    assert (
        "needs 2.2 iterations in environment 2; Table 2 gives the same algorithm 1.2 (x1), 1.4 (x2) or 1.6" in text
    )


@pytest.mark.parametrize(("length", "pair"), [(30.3848, (12, 13)), (51.1127, (20, 22)), (35.0771, None)])
def test_lengths_are_taken_apart(length: float, pair: tuple[int, int] | None) -> None:
    assert decompose(length) == pair


def test_the_equations_stand_in_the_papers_order() -> None:
    numbers = [int(equation.removeprefix("Eq. ")) for equation in EQUATIONS]
    assert numbers == sorted(numbers)
