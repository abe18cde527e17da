"""What the paper says of each environment, as far as the search may know it: its optimum, its standard-ACO rows.

The rows of ACO-PD, ACO-PDG and ACO-PF are not here. What the maps say of those algorithms is a prediction.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cached_property
from importlib.resources import files

import numpy as np

from acoexp.reconstruct.outcomes import Outcomes

Pair = tuple[int, int]

RULES = ("free", "no_squeeze", "no_cut")
"""The rules for diagonals that the paper's maps may be under: its paths have diagonals."""

CYCLES = 200
"""Cycles of a trial, so no x1 or x3 is later."""


@dataclass(frozen=True)
class Environment:
    """One of the paper's environments, 20 x 20 from corner to corner.

    Attributes:
        name: As the built-in map is called.
        optimum: Its exact optimum as (straight, diagonal) moves.
        local_optima: The other lengths of which the paper's standard ACO says l1 or l2, as pairs.
        has_trials: Whether the paper prints ten trials of standard ACO.
    """

    name: str
    optimum: Pair
    local_optima: tuple[Pair, ...]
    has_trials: bool

    @cached_property
    def trials(self) -> Outcomes:
        """The ten published trials of standard ACO, lengths to the printed four decimals; none for env1."""
        columns: dict[str, list[float]] = {"x1": [], "x3": [], "l1": [], "l2": []}
        if self.has_trials:
            text = files("acoexp.reconstruct").joinpath("data", f"{self.name}.csv").read_text(encoding="utf-8")
            for row in csv.DictReader(text.splitlines()):
                for key, column in columns.items():
                    column.append(float(row[key]))
        x1, x3 = (np.array(columns[key], dtype=np.int64) for key in ("x1", "x3"))
        return Outcomes(x1, x3, np.array(columns["l1"]), np.array(columns["l2"]))


ENVIRONMENTS = {
    env.name: env
    for env in (
        Environment("fig13", (12, 13), ((14, 14),), True),
        Environment("env1", (18, 10), (), False),
        Environment("env2", (28, 5), ((30, 4), (34, 2), (32, 4), (36, 2)), True),
    )
}
