"""A study: the configurations of both designs, each with its seeds, and what their trials came to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from acoexp.report.context import Context
from acoexp.report.progress import shown_progress
from acoexp.sensitivity.design import Level, Values, levels, saltelli
from acoexp.sensitivity.factors import settings_with
from acoexp.sensitivity.outcomes import OUTCOMES, Array, Measured
from acoexp.sensitivity.shares import Shares, shares_of
from acoexp.sensitivity.span import Factor
from acoexp.trial.seeds import Seeds, parse_seeds


@dataclass(frozen=True)
class Study:
    """What is to be run.

    Attributes:
        factors: The keys that are varied.
        points: Points of each sample of the design.
        replicates: Trials at each of them, each with a seed of its own.
        trials: Trials of each value of a curve, with the seeds 0, 1, ... for all.
    """

    factors: Sequence[Factor]
    points: int
    replicates: int
    trials: int

    @cached_property
    def levels(self) -> list[Level]:
        """The points of the curves."""
        return levels(self.factors)

    @cached_property
    def design(self) -> list[Values]:
        """The points of the design, sample by sample."""
        return saltelli(self.factors, self.points)

    @property
    def configurations(self) -> int:
        """How many configurations it runs."""
        return len(self.levels) + (len(self.factors) + 2) * self.points

    @property
    def size(self) -> int:
        """How many trials it runs."""
        return len(self.levels) * self.trials + (len(self.factors) + 2) * self.points * self.replicates

    def run(self, context: Context) -> Findings:
        """Run what is missing of it.

        Raises:
            SettingsError: for values that no configuration may have together; nothing has run then.
            StrategyError: if a trial failed.
        """
        values = [*({level.key: level.value} for level in self.levels), *self.design]
        settings = [settings_with(context.settings, context.algo, one) for one in values]
        seeds = [_seeds(0, self.trials)] * len(self.levels)
        seeds += [
            _seeds(self.trials + place * self.replicates, self.replicates) for place in range(len(self.design))
        ]
        measured = []
        with shown_progress(self.size) as show:
            shown = replace(context, show=show)
            for number, (one, its_seeds) in enumerate(zip(settings, seeds, strict=True), start=1):
                trials = shown.run(one, context.grid, its_seeds, f"configuration {number} of {len(settings)}")
                measured.append(Measured.of(trials, context.grid, one))
        return Findings(self, measured[: len(self.levels)], measured[len(self.levels) :])


@dataclass(frozen=True, eq=False)
class Findings:
    """What the trials of a study came to.

    Attributes:
        study: The study.
        curves: At each point of the curves.
        design: At each point of the design.
    """

    study: Study
    curves: Sequence[Measured]
    design: Sequence[Measured]

    @cached_property
    def worst_gap(self) -> float:
        """The largest gap of all trials, taken for those in which no ant arrived; 0 if none ever did."""
        gaps: Array = np.concatenate([one.outcomes["gap"] for one in (*self.curves, *self.design)])
        return float(np.nanmax(gaps)) if not np.isnan(gaps).all() else 0.0

    @property
    def never_arrived(self) -> int:
        """In how many trials no ant arrived."""
        return sum(one.never_arrived for one in (*self.curves, *self.design))

    @cached_property
    def shares(self) -> dict[str, Shares | None]:
        """How the variance of each outcome is made up; None where it has none."""
        shape = len(self.study.factors) + 2, self.study.points, self.study.replicates
        outcomes = [one.with_gap(self.worst_gap) for one in self.design]
        return {name: shares_of(np.reshape([one[name] for one in outcomes], shape)) for name in OUTCOMES}


def _seeds(first: int, number: int) -> Seeds:
    return parse_seeds(f"{first}-{first + number - 1}")
