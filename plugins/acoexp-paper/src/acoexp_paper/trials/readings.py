"""Readings: the decisions that the paper leaves open, each taken otherwise alone, and a few together."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from acoexp.compare.sample import Sample
from acoexp_paper.published.tables import ENVIRONMENTS, TABLES
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.samples import Samples, first_trials

ENVS = tuple(TABLES.values())
"""env1 has no published rows but Table 3's."""

_OF_DIFFUSION = ("diffusion", "field")
"""Keys that change nothing for standard ACO."""


class Reading(NamedTuple):
    """One way to read the paper.

    Attributes:
        text: Its keys as on the command line.
        values: The same as settings.
    """

    text: str
    values: Mapping[str, Any]

    def of(self, algo: str) -> dict[str, Any]:
        """Return the settings that it changes for an algorithm; none if it is the same as under the defaults."""
        return {key: value for key, value in self.values.items() if algo != "aco" or key not in _OF_DIFFUSION}


DEFAULT = Reading("the defaults", {})

READINGS = (
    DEFAULT,
    Reading("pheromone=cells", {"pheromone": "cells"}),
    Reading("order=lock_step", {"order": "lock_step"}),
    Reading("heuristic.at_goal=1", {"heuristic": {"at_goal": 1.0}}),
    Reading("heuristic.at_goal=10000", {"heuristic": {"at_goal": 1e4}}),
    Reading("q=100", {"q": 100.0}),
    Reading("tau0=8", {"tau0": 8.0}),
    Reading("field.obstacles=nearest", {"field": {"obstacles": "nearest"}}),
    Reading("field.repulsion=5", {"field": {"repulsion": 5.0}}),
    Reading("field.repulsion=100", {"field": {"repulsion": 100.0}}),
    Reading("field.reach=2", {"field": {"reach": 2.0}}),
    *(
        Reading(f"diffusion.source={source}", {"diffusion": {"source": source}})
        for source in ("walked_edge", "sum_in", "mean_out", "max_out")
    ),
    Reading(
        "pheromone=cells diffusion.source=walked_edge",
        {"pheromone": "cells", "diffusion": {"source": "walked_edge"}},
    ),
    Reading(
        "order=lock_step diffusion.source=walked_edge",
        {"order": "lock_step", "diffusion": {"source": "walked_edge"}},
    ),
    Reading("q=100 tau0=8", {"q": 100.0, "tau0": 8.0}),
)


def samples_of_readings(experiment: Experiment) -> list[tuple[Reading, dict[str, Samples]]]:
    """Run all readings on the maps of the environments with published rows; return their samples by environment.

    An algorithm that a reading does not change keeps its samples.
    """
    return [
        (
            reading,
            {
                env: {algo: _sample(experiment, reading.of(algo), env, algo) for algo in ENVIRONMENTS[env].algos}
                for env in ENVS
            },
        )
        for reading in READINGS
    ]


def trials_of_readings(experiment: Experiment) -> int:
    """Return how many trials all readings need."""
    changed = (bool(reading.of(algo)) for reading in READINGS for env in ENVS for algo in ENVIRONMENTS[env].algos)
    return experiment.ensemble_trials * sum(changed)


def _sample(experiment: Experiment, values: Mapping[str, Any], env: str, algo: str) -> Sample:
    if not values and experiment.trials >= experiment.ensemble_trials:
        return first_trials(experiment.main[env][algo], experiment.ensemble_trials)
    return experiment.varied(algo, values, experiment.maps[env])
