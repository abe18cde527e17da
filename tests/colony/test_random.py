"""The random numbers are xoshiro256++ seeded through SplitMix64, bit by bit, as their authors publish them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from reference import Random
from scipy.stats import chisquare, kstest

from acoexp.colony.random import seed_stream, uniform

WORDS = st.integers(0, 2**64 - 1)

SPLITMIX64 = {
    0: [0xE220A8397B1DCDAF, 0x6E789E6AA1B965F4, 0x06C45D188009454F, 0xF88BB8A8724C81EC],
    1234567: [6457827717110365317, 3203168211198807973, 9817491932198370423, 4593380528125082431],
}
"""First numbers of SplitMix64, by seed."""

XOSHIRO256PP = [
    41943041, 58720359, 3588806011781223, 3591011842654386, 9228616714210784205,
    9973669472204895162, 14011001112246962877, 12406186145184390807, 15849039046786891736, 10450023813501588000,
]  # fmt: skip
"""First numbers of xoshiro256++ from the state 1, 2, 3, 4."""


@pytest.fixture(autouse=True)
def _wrap_around() -> Iterator[None]:
    """64-bit words wrap around on purpose; NumPy says so when nothing is compiled."""
    with np.errstate(over="ignore"):
        yield


def stream(seed: int) -> NDArray[np.uint64]:
    state = np.zeros(4, dtype=np.uint64)
    seed_stream(state, np.uint64(seed))
    return state


def draws(state: NDArray[np.uint64], count: int) -> list[float]:
    return [uniform(state) for _ in range(count)]


@pytest.mark.parametrize("seed", SPLITMIX64)
def test_a_seed_becomes_four_numbers_of_splitmix64(seed: int) -> None:
    assert stream(seed).tolist() == SPLITMIX64[seed]


def test_numbers_are_the_upper_53_bits_of_xoshiro256pp() -> None:
    state = np.array([1, 2, 3, 4], dtype=np.uint64)
    assert draws(state, 10) == [(word >> 11) / 2**53 for word in XOSHIRO256PP]


def test_the_reference_draws_the_published_numbers_too() -> None:
    reference = Random(0)
    assert reference.words == SPLITMIX64[0]
    reference.words = [1, 2, 3, 4]
    assert [reference.word() for _ in range(10)] == XOSHIRO256PP


@settings(deadline=None)
@given(WORDS)
def test_any_seed_gives_the_references_stream(seed: int) -> None:
    reference, state = Random(seed), stream(seed)
    assert draws(state, 20) == [reference.uniform() for _ in range(20)]
    assert state.tolist() == reference.words


@settings(deadline=None)
@given(st.lists(WORDS, min_size=4, max_size=4))
def test_a_number_is_at_least_0_and_below_1_whatever_the_state(words: list[int]) -> None:
    assert 0.0 <= uniform(np.array(words, dtype=np.uint64)) < 1.0


def test_the_largest_number_is_still_below_1() -> None:
    state = np.array([2**64 - 1, 0, 0, 1], dtype=np.uint64)  # s0 + s3 = 0, and 0 + s0 has all bits set
    assert uniform(state) == 1.0 - 2.0**-53


def test_numbers_are_uniform_and_do_not_depend_on_the_one_before() -> None:
    numbers = np.array(draws(stream(2017), 20_000))
    assert kstest(numbers, "uniform").pvalue > 0.001
    pairs = np.histogram2d(numbers[0::2], numbers[1::2], bins=10, range=[[0, 1], [0, 1]])[0]
    assert chisquare(pairs.ravel()).pvalue > 0.001


def test_streams_of_neighbouring_seeds_have_nothing_in_common() -> None:
    firsts = np.array([uniform(stream(seed)) for seed in range(2000)])
    assert kstest(firsts, "uniform").pvalue > 0.001
    assert abs(np.corrcoef(firsts[:-1], firsts[1:])[0, 1]) < 0.1
