"""The rule's operating characteristics, in a short form."""

from __future__ import annotations

import pytest
from acoexp_paper.claims.characteristics import COMPARISONS, PRINTED, Truth, frequencies, main

FEW, SIMULATIONS = 100, 60


def often(truth: Truth) -> dict[str, float]:
    return frequencies(truth, FEW, SIMULATIONS, seed=1)


def test_what_is_true_alike_with_a_win_share_of_60_percent_is_shown() -> None:
    assert often(Truth("", 0.60))["shown"] >= 0.9


def test_what_is_not_so_is_hardly_ever_shown_or_contradicted_and_equal_maps_hardly_ever_differ() -> None:
    found = often(Truth("", 0.50))
    assert found["shown"] + found["contradicted"] <= 0.15
    assert found["depends on the map"] <= 0.15


def test_what_differs_between_maps_is_seen_to() -> None:
    assert often(Truth("", 0.50, 0.15))["depends on the map"] >= 0.9


def test_a_true_number_is_compatible() -> None:
    assert often(Truth("", 10.0, 0.0, 10.0))["compatible"] >= 0.8
    assert often(Truth("", 10.0, 0.0, 40.0))["contradicted"] >= 0.9


def test_the_command_prints_a_table_of_comparisons_and_one_of_numbers(capsys: pytest.CaptureFixture[str]) -> None:
    main(["--simulations", "1", "--trials", "20"])
    printed = capsys.readouterr().out
    assert printed.count("Per cent of 1 simulated claims, 22 maps, seed 0.") == 2
    assert all(f"| {truth.text} | 20 | " in printed for truth in (*COMPARISONS, *PRINTED))


@pytest.mark.parametrize("given", [["--simulations", "0"], ["--trials", "1"], ["--seed", "-1"]])
def test_a_number_out_of_range_is_refused(given: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(given)
    assert f"argument {given[0]}: expected a whole number from " in capsys.readouterr().err
