"""What maps weigh by how well they meet the rows that they were fitted to."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.likelihood import of_themselves, scores, weights

from acoexp.grid.grid import Grid
from acoexp.registry.load_map import load_map


def with_score(*values: float | str) -> list[Grid]:
    return [Grid(np.zeros((3, 3)), metadata={"score": value}) for value in values]


def test_a_map_brings_its_score_along() -> None:
    assert scores([load_map("fig13")])[0] < -50.0
    assert np.isnan(scores([Grid(np.zeros((3, 3)))])).all()


@pytest.mark.parametrize(("env", "expected"), [("fig13", -59.6), ("env2", -52.0)])
def test_the_published_rows_have_more_than_any_map_under_themselves(env: str, expected: float) -> None:
    assert of_themselves(env) == pytest.approx(expected, abs=0.05)


def test_maps_weigh_as_their_likelihoods() -> None:
    found = weights(with_score("-70.0", "-71.0"))
    assert found is not None
    assert found.sum() == pytest.approx(1.0)
    assert found[0] / found[1] == pytest.approx(np.e)


def test_no_map_is_all_there_is() -> None:
    found = weights(with_score(-70.0, -7000.0))
    assert found is not None
    assert found[1] > 0.0


def test_a_single_map_and_one_whose_score_is_unknown_leave_no_weights() -> None:
    assert weights(with_score(-70.0)) is None
    assert weights([*with_score(-70.0), Grid(np.zeros((3, 3)))]) is None
