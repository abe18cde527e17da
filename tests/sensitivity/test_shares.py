"""Shares of variance: held against functions whose shares are known, with and without the chance of seeds."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest
import scipy

from acoexp.sensitivity.design import saltelli
from acoexp.sensitivity.shares import Shares, shares_of
from acoexp.sensitivity.span import Factor, Span


def outcomes(
    function: Callable[..., Any], spans: Sequence[Span], points: int, trials: int = 2, noise: float = 0.0
) -> Any:
    """Return a function's values at the design, each trial with noise of its own of this deviation."""
    factors = [Factor(f"x{place}", span, 0.0) for place, span in enumerate(spans)]
    x = np.array([list(point.values()) for point in saltelli(factors, points)])
    chance = noise * np.random.default_rng(7).normal(size=(len(x), trials))
    return (function(*x.T)[:, None] + chance).reshape(len(spans) + 2, points, trials)


def shares(*given: Any, **options: Any) -> Shares:
    found = shares_of(outcomes(*given, **options))
    assert found is not None
    return found


def ishigami(x: Any, y: Any, z: Any) -> Any:
    """Ishigami and Homma 1990, with a = 7 and b = 0.1."""
    return np.sin(x) + 7.0 * np.sin(y) ** 2 + 0.1 * z**4 * np.sin(x)


WHOLE_TURN = [Span(-np.pi, np.pi)] * 3
# variances by hand, as in Sobol and Levitan 1999
V_X, V_Y, V_XZ = 0.5 * (1.0 + 0.1 * np.pi**4 / 5.0) ** 2, 49.0 / 8.0, 0.01 * np.pi**8 * (1.0 / 18.0 - 1.0 / 50.0)
V = V_X + V_Y + V_XZ


def values(parts: Sequence[Any]) -> list[float]:
    return [part.value for part in parts]


def test_ishigamis_function_has_its_known_shares() -> None:
    found = shares(ishigami, WHOLE_TURN, 2048)
    assert values(found.alone) == pytest.approx([V_X / V, V_Y / V, 0.0], abs=0.02)
    assert values(found.total) == pytest.approx([(V_X + V_XZ) / V, V_Y / V, V_XZ / V], abs=0.02)
    assert found.together.value == pytest.approx(V_XZ / V, abs=0.03)
    assert found.seeds.value == 0.0
    assert found.first[0] > 0.99


def test_the_chance_of_seeds_is_told_apart_from_keys_and_from_what_they_do_together() -> None:
    found = shares(ishigami, WHOLE_TURN, 2048, trials=3, noise=np.sqrt(V))  # seeds make half of it
    assert values(found.alone) == pytest.approx([V_X / V / 2, V_Y / V / 2, 0.0], abs=0.04)
    assert values(found.total) == pytest.approx([(V_X + V_XZ) / V / 2, V_Y / V / 2, V_XZ / V / 2], abs=0.04)
    assert found.seeds.value == pytest.approx(0.5, abs=0.02)


def test_a_sum_has_the_shares_of_its_terms_and_nothing_together() -> None:
    found = shares(lambda x, y, z: 1.0 * x + 2.0 * y + 3.0 * z, [Span(0.0, 1.0)] * 3, 512)
    expected = [1.0 / 14.0, 4.0 / 14.0, 9.0 / 14.0]
    assert values(found.alone) == pytest.approx(expected, abs=0.01)
    assert values(found.total) == pytest.approx(expected, abs=0.01)
    assert found.together.value == pytest.approx(0.0, abs=0.01)


def test_without_chance_they_are_scipys_indices() -> None:
    given = outcomes(ishigami, WHOLE_TURN, 64)
    found = shares_of(given)
    assert found is not None
    a, b, *mixed = given[:, :, 0]
    func = {"f_A": a[None], "f_B": b[None], "f_AB": np.array(mixed)[:, None]}
    scipys = scipy.stats.sobol_indices(func=func, n=64)
    assert values(found.alone) == pytest.approx(scipys.first_order)
    assert values(found.total) == pytest.approx(scipys.total_order)


def test_shares_add_up_to_one() -> None:
    found = shares(ishigami, WHOLE_TURN, 64, trials=3, noise=2.0)
    assert sum(values(found.alone)) + found.together.value + found.seeds.value == pytest.approx(1.0, abs=1e-9)


def test_the_interval_holds_what_is_true_and_is_narrower_for_more_points() -> None:
    wide, narrow = (shares(ishigami, WHOLE_TURN, n, trials=4, noise=np.sqrt(V)) for n in (64, 1024))
    for found in (wide, narrow):
        assert all(part.low <= part.value <= part.high for part in (*found.alone, *found.total, found.seeds))
        assert found.alone[1].low <= V_Y / V / 2 <= found.alone[1].high
        assert found.seeds.low <= 0.5 <= found.seeds.high
    assert narrow.total[0].high - narrow.total[0].low < 0.5 * (wide.total[0].high - wide.total[0].low)


def test_keys_that_do_nothing_are_told_from_nothing() -> None:
    found = shares(lambda x, y: 0.0 * x, [Span(0.0, 1.0)] * 2, 256, trials=4, noise=1.0)
    assert all(part.low <= 0.0 <= part.high for part in (*found.alone, *found.total, found.together))
    assert found.seeds.value == pytest.approx(1.0, abs=0.1)
    assert max(found.first) < 0.95


def test_one_key_alone() -> None:
    found = shares(lambda x: x, [Span(0.0, 1.0)], 64)
    assert (found.alone[0].value, found.total[0].value) == (
        pytest.approx(1.0, abs=0.02),
        pytest.approx(1.0, abs=0.02),
    )
    assert found.first.tolist() == [1.0]


def test_whole_numbers_and_choices_are_keys_like_others() -> None:
    spans = [Span(1.0, 4.0, whole=True), Span(0.0, 1.0, values=(0.0, 1.0))]
    found = shares(lambda x, y: x + y, spans, 256)
    assert values(found.alone) == pytest.approx([1.25 / 1.5, 0.25 / 1.5], abs=0.02)


def test_what_never_varies_has_no_shares() -> None:
    assert shares_of(np.full((4, 8, 2), 3.0)) is None


def test_they_are_the_same_each_time() -> None:
    once, again = (shares(ishigami, WHOLE_TURN, 16, noise=1.0) for _ in range(2))
    assert (once.alone, once.total, once.seeds) == (again.alone, again.total, again.seeds)
