"""Trials that are made up, in no time: of which it is known what they say, or like those of a colony."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from zlib import crc32

import numpy as np
import pytest
from acoexp_paper.claims.kinds import Claim, Kind
from acoexp_paper.claims.verdicts import judge
from acoexp_paper.trials import experiment as experiments
from acoexp_paper.trials.concentration import ENTROPY, ON_SHORTEST
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.samples import Samples

from acoexp.compare.measures import measured
from acoexp.compare.sample import Sample
from acoexp.grid.grid import Grid
from acoexp.trial.seeds import Seeds, parse_seeds
from acoexp.trial.settings import Settings
from acoexp.trial.trials import Trials

N = 400
_SLOWEST = {"aco": 11, "pd": 9, "pdg": 4, "pf": 8}


def sample(x1: int = 5, found: float = 1.0, converged: float = 1.0, seed: int = 0) -> Sample:
    """Return trials around x1, of which such shares find and keep the optimum, 10."""
    random = np.random.default_rng(seed)
    first = random.integers(x1 - 2, x1 + 3, N).astype(float)
    l1 = np.where(random.random(N) < found, 10.0, 11.0)
    l2 = np.where(random.random(N) < converged, l1, 12.0)
    features = {"x1": first, "x2": first, "x3": first, "l1": l1, "l2": l2, "lost_ants": first}
    curves = np.tile(l2[:, None], (1, 50))
    return Sample("", "map", 10.0, l1 == 10.0, features, curves, np.ones(curves.shape, dtype=np.int64))


def made_trials(settings: Settings, grid: Grid, seeds: Seeds, show: Callable[[int], None]) -> Trials:
    """Return trials in which one algorithm finds the optimum sooner than another; one of five leaves it again."""
    n, iterations = len(seeds), settings.scalars.iterations
    random = np.random.default_rng(crc32(f"{settings.label} {grid.name}".encode()))
    before = np.arange(iterations) < random.integers(1, _SLOWEST.get(settings.label, 10), (n, 1))
    leaves = (np.arange(iterations) == iterations - 1) & (random.random((n, 1)) < 0.2)
    pairs = np.tile(grid.optimum_pair, (n, iterations, 1))
    pairs[before | leaves] += (2, 0)
    show(n)
    lost, steps = random.integers(0, 3, (n, iterations)), np.ones((n, iterations), dtype=np.int64)
    return Trials(seeds.array(), pairs, lost, steps, np.full(n, iterations, np.int32), np.zeros((n, 5)))


def made_concentration(sample: Sample, grid: Grid, settings: Settings) -> Sample:
    """Return a sample with made-up features of its pheromone."""
    random = np.random.default_rng(crc32(f"{settings.label} {sample.map} pheromone".encode()))
    spread = random.random(sample.found.size)
    return replace(sample, features={**sample.features, ON_SHORTEST: spread, ENTROPY: 1.0 - spread})


def made_unkept(
    experiment: Experiment, env: str, settings: Settings, grids: Sequence[Grid], trials: int, text: str
) -> list[Sample]:
    """Return made-up samples on some maps, as :meth:`Experiment.unkept` returns them."""
    seeds = parse_seeds(f"0-{trials - 1}")
    made = ((grid, made_trials(settings, grid, seeds, lambda done: None)) for grid in grids)
    return [made_concentration(measured(settings.label, grid, one), grid, settings) for grid, one in made]


def make_up(patch: pytest.MonkeyPatch) -> None:
    """Let nothing run but what is made up."""
    patch.setattr(experiments, "with_concentration", made_concentration)
    patch.setattr(Experiment, "unkept", made_unkept)


def verdict(kind: Kind, *maps: Samples) -> str:
    """Return the verdict on a claim of some maps' samples."""
    (judged,) = judge([Claim("", "env2", kind)], {"env2": maps})
    return judged.verdict
