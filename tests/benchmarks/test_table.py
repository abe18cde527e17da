"""The table of all benchmarks, on rows made up: what it shows, what it marks, and what it is compared with."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from rows import Row
from table import HEADING, find, line, marks, read, write
from timing import Timing, spread

STEP = Row(name="an ant step", value=18.84, unit="ns", ratio=1.05, base="C++", spread=0.01, aim=1.1)
MEMORY = Row(name="memory", value=217.4, unit="bytes per cell", aim=250.0)
THREADS = Row(name="one thread", value=150.0, unit="ms", ratio=1.95, base="two", aim=1.9, at_least=True)


def test_a_row_is_a_line_with_as_many_cells_as_the_heading() -> None:
    assert line("speed", STEP, None) == "| speed | an ant step | 18.8 ns | 1.05 x C++ | 1.1 |  |  |"
    assert line("speed", MEMORY, MEMORY) == "| speed | memory | 217 bytes per cell |  | 250 | 217 |  |"
    noted = replace(THREADS, note="busy")
    assert (
        line("speed", noted, THREADS)
        == "| speed | one thread | 150 ms | 1.95 x two | at least 1.9 | 1.95 | busy |"
    )
    for row in (STEP, MEMORY, THREADS):
        assert {text.count("|") for text in [*HEADING.splitlines(), line("speed", row, row)]} == {8}


@pytest.mark.parametrize(
    ("row", "now", "expected"),
    [
        (STEP, 1.08, []),  # within twice the spread of both runs
        (STEP, 1.095, ["**worse**"]),
        (STEP, 1.2, ["**misses the aim**", "**worse**"]),
        (STEP, 0.5, []),
        (THREADS, 1.91, []),
        (THREADS, 1.8, ["**misses the aim**", "**worse**"]),
        (THREADS, 3.0, []),
    ],
)
def test_what_got_worse_by_more_than_the_noise_is_marked(row: Row, now: float, expected: list[str]) -> None:
    assert marks(replace(row, ratio=now), row) == expected


def test_what_has_no_ratio_is_compared_by_its_value() -> None:
    assert marks(replace(MEMORY, value=240.0), MEMORY) == ["**worse**"]
    assert marks(replace(MEMORY, value=260.0), None) == ["**misses the aim**"]


def test_a_file_gives_back_what_was_written_and_keeps_what_was_not_measured(tmp_path: Path) -> None:
    file = tmp_path / "last.json"
    assert read(file) == {}
    write(file, {"speed": [STEP, MEMORY], "large": [MEMORY]})
    write(file, {"speed": [THREADS]})
    assert read(file) == {"speed": [THREADS], "large": [MEMORY]}
    assert find(read(file), "speed", "one thread") == THREADS
    assert find(read(file), "speed", "an ant step") is None
    assert [path.name for path in tmp_path.iterdir()] == ["last.json"]


def test_ratios_are_of_the_same_round_and_the_median_is_shown() -> None:
    timing = Timing({"a": [1e-9, 4e-9, 30e-9], "b": [1e-9, 2e-9, 10e-9]})
    row = timing.row("a", "b", unit="ns", aim=3.0)
    assert (row.name, row.value, row.ratio, row.base, row.aim) == ("a", pytest.approx(4.0), 2.0, "b", 3.0)
    assert row.spread == pytest.approx(0.5)
    assert timing.row("b", unit="ms", name="alone").ratio is None


def test_the_spread_is_that_of_the_middle_half() -> None:
    assert spread([2.0]) == 0.0
    assert spread([1.0, 3.0]) == 0.5
    assert spread([1.0, 9.0, 10.0, 11.0, 10.0, 10.0, 100.0]) == pytest.approx(0.1)
