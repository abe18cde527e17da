"""Which single trials the figures show."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from acoexp.trial.result import Result
from acoexp.trial.solver import Solver
from acoexp_paper.figures.maps import length_of
from acoexp_paper.trials.experiment import Experiment

TRIES = 1000
"""Ants among whom that of Fig. 13 is looked for."""

AS_WALKED, OPTIMISED = 51.1127, 41.4558
"""The lengths, in cells, of the paper's ant of Figs 13 and 14."""


def best_run(experiment: Experiment, env: str) -> Result:
    """Return the first run of ACO-PDG that found the optimum; if none did, the first with the shortest path."""
    shortest = np.nan_to_num(experiment.main[env]["pdg"].features["l1"], nan=math.inf)
    return Solver(experiment.maps[env], experiment.settings("pdg", {})).solve(int(np.argmin(shortest)))


def one_ant(experiment: Experiment) -> Result:
    """Return the ant whose path is most like the one of the paper's Fig. 13, among the first seeds' first ants."""
    settings = experiment.settings("pdg", {})
    alone = replace(settings, scalars=replace(settings.scalars, ants=1, iterations=1))
    results = Solver(experiment.maps["fig13"], alone).solve_many(range(TRIES), threads=1)
    return min(results, key=lambda result: (_unlike_the_papers(result), result.seed))


def _unlike_the_papers(result: Result) -> float:
    """Return how far, in cells, an ant's path is from the lengths that the paper gives for that of Fig. 13."""
    if result.raw_path is None:
        return math.inf
    return abs(length_of(result.raw_path) - AS_WALKED) + abs(result.length - OPTIMISED)
