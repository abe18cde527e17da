"""Readings: the decisions that the paper leaves open, each taken otherwise alone, and a few together."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from acoexp_paper.averages import fit_of
from acoexp_paper.experiment import Experiment, Samples, first
from acoexp_paper.published import ENVIRONMENTS
from acoexp_paper.verdicts import says_of_reading

ENVS = ("fig13", "env2")
"""env1 has no published rows but Table 3's."""

_DIFFUSES = ("pd", "pdg", "pf")
_ALL = ("aco", *_DIFFUSES)


class Reading(NamedTuple):
    """One way to read the paper.

    Attributes:
        text: Its keys as on the command line.
        values: The same as settings.
        algos: The algorithms that it changes.
    """

    text: str
    values: Mapping[str, Any]
    algos: tuple[str, ...] = _ALL


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


DEFAULT = Reading("the defaults", {}, ())

READINGS = (
    DEFAULT,
    Reading("pheromone=cells", {"pheromone": "cells"}),
    Reading("order=lock_step", {"order": "lock_step"}),
    Reading("heuristic.at_goal=1", {"heuristic": {"at_goal": 1.0}}),
    Reading("heuristic.at_goal=10000", {"heuristic": {"at_goal": 1e4}}),
    Reading("q=100", {"q": 100.0}),
    Reading("tau0=8", {"tau0": 8.0}),
    Reading("field.obstacles=nearest", {"field": {"obstacles": "nearest"}}, _DIFFUSES),
    Reading("field.repulsion=5", {"field": {"repulsion": 5.0}}, _DIFFUSES),
    Reading("field.repulsion=100", {"field": {"repulsion": 100.0}}, _DIFFUSES),
    Reading("field.reach=2", {"field": {"reach": 2.0}}, _DIFFUSES),
    *(
        Reading(f"diffusion.source={source}", {"diffusion": {"source": source}}, _DIFFUSES)
        for source in ("walked_edge", "sum_in", "mean_out", "max_out")
    ),
    Reading(
        "pheromone=cells diffusion.source=walked_edge",
        {"pheromone": "cells", "diffusion": {"source": "walked_edge"}},
        _DIFFUSES,
    ),
    Reading(
        "order=lock_step diffusion.source=walked_edge",
        {"order": "lock_step", "diffusion": {"source": "walked_edge"}},
        _DIFFUSES,
    ),
    Reading("q=100 tau0=8", {"q": 100.0, "tau0": 8.0}),
)


def outcomes(experiment: Experiment) -> list[Outcome]:
    """Run and judge all readings on the maps of the environments with published rows."""
    ready = {reading.text: _samples(experiment, reading) for reading in READINGS}
    return [
        Outcome(
            reading,
            {(t, env, a): n for env in ENVS for (t, a), n in fit_of(env, ready[reading.text][env]).items()},
            says_of_reading(ready[reading.text]),
        )
        for reading in READINGS
    ]


def _samples(experiment: Experiment, reading: Reading) -> dict[str, Samples]:
    """Return the samples of a reading by environment; an algorithm that it does not change keeps its own."""
    trials = experiment.ensemble_trials
    return {
        env: {
            algo: experiment.varied(algo, reading.values if algo in _changed(reading) else {}, experiment.maps[env])
            if algo in _changed(reading) or trials > experiment.trials
            else first(experiment.main[env][algo], trials)
            for algo in ENVIRONMENTS[env].algos
        }
        for env in ENVS
    }


def _changed(reading: Reading) -> tuple[str, ...]:
    return reading.algos
