"""What a benchmark gives: rows of data, or a line that says what it left out; and what it is given."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, kw_only=True)
class Row:
    """One figure, and how it stands to another of the same run.

    Attributes:
        name: What was measured; with the benchmark's name it tells rows apart.
        value: The figure, in its unit; of times the median.
        unit: Its unit.
        ratio: How many times the other's it is, the median of the rounds' ratios; None if it has no other side.
        base: The other side.
        spread: Half of the range in which the middle half of these ratios lies, as a share of the ratio.
        aim: The bound that we hold ourselves to: of the ratio, or of the value where there is no ratio.
        at_least: Whether more is better.
        note: What else is to be said.
    """

    name: str
    value: float
    unit: str
    ratio: float | None = None
    base: str = ""
    spread: float = 0.0
    aim: float | None = None
    at_least: bool = False
    note: str = ""

    @property
    def compared(self) -> float:
        """What is compared with the aim, and with the last time."""
        return self.value if self.ratio is None else self.ratio


@dataclass(frozen=True, kw_only=True)
class Given:
    """What the command was told.

    Attributes:
        rounds: How often both sides of a ratio are measured; None for as often as the benchmark thinks right.
        worktree: Another version of acoexp to compare with.
        maps: A folder of maps of the MovingAI benchmarks with their scenarios, or of ROS.
    """

    rounds: int | None = None
    worktree: Path | None = None
    maps: Path | None = None


Benchmark = Callable[[Given], Iterator[Row | str]]
"""Rows as they are measured; a text is a line that says what is left out, and why."""
