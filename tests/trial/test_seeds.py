"""Seeds of a batch, as a person writes them."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from acoexp.errors import SettingsError
from acoexp.trial.seeds import HIGHEST_SEED, MOST_SEEDS, parse_seeds


@pytest.mark.parametrize(
    ("written", "seeds", "canonical"),
    [
        ("0-3", [0, 1, 2, 3], "0-3"),
        ("7", [7], "7"),
        (7, [7], "7"),
        ("20,0-2", [0, 1, 2, 20], "0-2,20"),
        ("0-1, 2-3", [0, 1, 2, 3], "0-3"),
        ("5-5", [5], "5"),
        (f"{HIGHEST_SEED - 1}-{HIGHEST_SEED}", [HIGHEST_SEED - 1, HIGHEST_SEED], None),
    ],
)
def test_ranges_and_numbers(written: Any, seeds: list[int], canonical: str | None) -> None:
    parsed = parse_seeds(written)
    assert (list(parsed), len(parsed)) == (seeds, len(seeds))
    assert parsed.array().tolist() == seeds
    assert str(parsed) == (canonical or written)


@given(st.sets(st.integers(0, 60), min_size=1))
def test_the_same_seeds_have_one_text_and_it_reads_back(seeds: set[int]) -> None:
    one_by_one = parse_seeds(",".join(map(str, seeds)))
    assert list(one_by_one) == sorted(seeds)
    assert parse_seeds(str(one_by_one)) == one_by_one


@pytest.mark.parametrize(
    "written",
    [
        "",
        "a",
        "1-",
        "-1",
        "3-1",
        "0-4,4",
        "1,1",
        "1.5",
        None,
        True,
        [1],
        str(2**64),
        "9" * 5000,
        f"0-{MOST_SEEDS}",
    ],
)
def test_what_is_no_list_of_seeds_is_refused(written: Any) -> None:
    with pytest.raises(SettingsError, match=r"^seeds?: expected"):
        parse_seeds(written)
