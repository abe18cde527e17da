"""The tables of the verdict: each number with its interval, a dash where there is no path."""

from __future__ import annotations

from compared import maps_of

from acoexp.compare.over_maps.tables import percent, verdict_tables
from acoexp.compare.over_maps.values import values_of_maps
from acoexp.compare.over_maps.verdict import Verdict, verdict_over


def verdict(*gaps: list[float]) -> Verdict:
    """Return the verdict on configurations a, b ... on maps of such gaps."""
    maps = maps_of(gaps, "abc"[: len(gaps[0])])
    return verdict_over(maps, values_of_maps(maps))


def test_ranks_stand_from_the_best_on_with_their_intervals() -> None:
    ranks, pairs = verdict_tables(verdict(*[[0.2, 0.1, float("inf")]] * 6))
    assert ranks.headings == ["cell", "mean rank", "best on", "lost on", "gap"]
    assert ranks.rows == [
        ["b", "1.00 [1.00, 1.00]", "6/6", "0/6", "10.0 %"],
        ["a", "2.00 [2.00, 2.00]", "0/6", "0/6", "20.0 %"],
        ["c", "3.00 [3.00, 3.00]", "0/6", "6/6", "-"],
    ]
    assert pairs.rows[0] == [
        "a", "b", "0 / 0 / 6", "0.00 [0.00, 0.00]", "[0.00, 0.00]", "-1.00", "0.193", "no difference shown",
    ]  # fmt: skip
    assert "Nemenyi's test" in pairs.note


def test_two_configurations_are_said_to_have_the_sign_test() -> None:
    _, pairs = verdict_tables(verdict(*[[0.2, 0.1]] * 6))
    assert pairs.rows[0][-2:] == ["0.031", "b better"]
    assert "the exact sign test over maps" in pairs.note


def test_without_enough_maps_there_are_ranks_alone_without_intervals() -> None:
    (ranks,) = verdict_tables(verdict([0.2, 0.1], [0.0, 0.0]))
    assert ranks.rows[0] == ["b", "1.25", "2/2", "0/2", "0.00 %"]


def test_gaps_are_in_per_cent() -> None:
    assert [percent(gap) for gap in (0.0, 0.0123, 1.5, float("inf"))] == ["0.00 %", "1.23 %", "150 %", "-"]
