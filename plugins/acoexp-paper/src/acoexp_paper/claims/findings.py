"""Findings: everything that the trials say of the averages and claims, from which the page is made."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from acoexp.compare.statistics import Values
from acoexp_paper.claims.averages import Average, Fit, averages, averages_met
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.likelihood import scores, weights
from acoexp_paper.claims.rereading import Outcome, outcome, with_changes
from acoexp_paper.claims.verdicts import Judged, judge
from acoexp_paper.published.tables import ALGOS
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.readings import ENVS, samples_of_readings
from acoexp_paper.trials.samples import Samples


class Findings(NamedTuple):
    """Everything that was found, in numbers.

    Attributes:
        experiment: The trials.
        scores: The log-likelihood of each map of each environment, its own map first, float[maps].
        averages: The averages of Tables 1 to 3.
        claims: The claims.
        met: By table, map and algorithm, how many published averages lie inside over all maps, of how many;
            without
            ACO-PF, with which other readings are not run.
        readings: What each other reading of the paper leads to; empty if they were left out.
    """

    experiment: Experiment
    scores: dict[str, Values]
    averages: list[Average]
    claims: list[Judged]
    met: Fit
    readings: list[Outcome]

    @classmethod
    def of(cls, experiment: Experiment, claims: Sequence[Claim]) -> Findings:
        """Run what is missing, and look at all of it."""
        maps = {env: experiment.maps_of(env) for env in experiment.maps}
        judged = judge(claims, experiment.samples, {env: weights(grids) for env, grids in maps.items()})
        outcomes = [
            outcome(reading, claims, samples, default)
            for reading, samples, default in (samples_of_readings(experiment) if experiment.reading_trials else ())
        ]
        return cls(
            experiment,
            {env: scores(grids) for env, grids in maps.items()},
            averages(experiment.samples),
            judged,
            averages_met({env: [_without_pf(samples) for samples in experiment.samples[env]] for env in ENVS}),
            with_changes(outcomes, {one.claim.key: one.verdict for one in judged}),
        )

    @property
    def counted(self) -> list[Judged]:
        """The claims that the maps were not fitted to."""
        return [one for one in self.claims if not one.claim.fitted]


def _without_pf(samples: Samples) -> Samples:
    """Return what other readings of the paper are run with."""
    return {algo: samples[algo] for algo in ALGOS}
