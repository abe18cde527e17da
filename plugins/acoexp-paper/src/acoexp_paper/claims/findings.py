"""Findings: everything that the trials say of the averages and claims, from which the page is made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from acoexp_paper.claims.averages import Average, averages, averages_met
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.verdicts import Judged, judge, says_of_samples
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.readings import Reading, samples_of_readings
from acoexp_paper.trials.samples import Samples


class Outcome(NamedTuple):
    """What a reading leads to.

    Attributes:
        reading: The reading.
        fit: By table, map and algorithm, how many published averages lie inside, of how many.
        says: By claim, 1 if it holds, -1 if the opposite does, 0 if neither.
    """

    reading: Reading
    fit: dict[tuple[int, str, str], tuple[int, int]]
    says: dict[str, int]

    @classmethod
    def of(cls, reading: Reading, claims: Sequence[Claim], samples: Mapping[str, Samples]) -> Outcome:
        """Judge a reading by its samples on each environment's map."""
        return cls(reading, averages_met(samples), says_of_samples(claims, samples))

    @property
    def inside(self) -> int:
        """How many published averages lie inside."""
        return sum(inside for inside, _ in self.fit.values())

    @property
    def averages(self) -> int:
        """Of how many."""
        return sum(of for _, of in self.fit.values())


class Findings(NamedTuple):
    """Everything that was found, in numbers.

    Attributes:
        experiment: The trials.
        averages: The averages of Tables 1 to 3.
        claims: The claims.
        readings: What each reading of the paper leads to; empty if they were left out.
    """

    experiment: Experiment
    averages: list[Average]
    claims: list[Judged]
    readings: list[Outcome]

    @classmethod
    def of(cls, experiment: Experiment, claims: Sequence[Claim]) -> Findings:
        """Run what is missing, and look at all of it."""
        readings = samples_of_readings(experiment) if experiment.ensemble_trials else []
        return cls(
            experiment,
            averages(experiment.main, experiment.ensembles),
            judge(claims, experiment.main, experiment.ensembles),
            [Outcome.of(reading, claims, samples) for reading, samples in readings],
        )
