"""The search: annealing over layouts whose exact optimum is the published one, candidates racing on fresh trials.

First the layout is bent until the optimum is right, which needs no ants. Then each step changes a rectangle or
two, keeps the optimum, and lets standard ACO run on the candidate: a few trials first, more only if it is still
in the race. No trial is looked at twice, and the incumbent has to run again and again, so that no map can stay
for having been lucky.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator

from acoexp.grid.grid import Grid
from acoexp.grid.moves import path_length
from acoexp.reconstruct.layout import Layout, is_layout, is_map, mutate, paint, random_layout
from acoexp.reconstruct.likelihood import score
from acoexp.reconstruct.outcomes import Outcomes
from acoexp.reconstruct.published import RULES, Environment
from acoexp.reconstruct.screen import Screen
from acoexp.trial.solver import Solver

FRESH_BELOW = 2**32
"""The search draws its trials' seeds from here on, so that every seed below is one that it never saw."""

_STARTS = 128
"""Layouts among which a run chooses where to begin."""

_RUNGS = (8, 16, 32, 64, 128)
"""Trials after which a candidate may drop out of the race; after the last it replaces the incumbent or not."""

_SLACK = 160.0
"""How far a candidate may lie behind: this over its trials, for so much its likelihood is underestimated."""

_HOT, _WARM, _COLD = 2.5, 1.0, 0.4
"""Temperature at the first step, at that of a run that begins with a map given, and at the last step."""

SEARCH_CYCLES = 100
"""Cycles of a trial while searching: by then colonies have converged, and what follows would double the time."""

_MOST_TRIALS = 512
"""Trials by which an incumbent is known well enough."""


@dataclass
class Candidate:
    """A layout, standard ACO on its map, and the trials that were run."""

    layout: Layout
    aco: Solver
    trials: Outcomes
    score: float


class Search:
    """One annealing run: its own random numbers and screen, and standard ACO that goes from map to map.

    Args:
        environment: What is reconstructed.
        seed: Of the random numbers.
        moves: Rule for diagonals; by default the seeds take turns.
        aco: Standard ACO with trials of ``SEARCH_CYCLES``, on any map.
    """

    def __init__(self, environment: Environment, seed: int, moves: str | None, aco: Solver) -> None:
        self.environment = environment
        self.rng: Generator = np.random.default_rng(seed)
        self.moves = RULES[seed % len(RULES)] if moves is None else moves
        self._screen = Screen(self.moves)
        self._aco = aco

    def run(self, steps: int, progress: Callable[[], None], begin: Layout | None = None) -> Layout:
        """Return the best map that so many steps lead to, from a layout given or from the best of many."""
        current = self._begun() if begin is None else self._tried(begin, _RUNGS[-1])
        first = _HOT if begin is None else _WARM
        elite = [current]
        for step in range(steps):
            temperature = first * (_COLD / first) ** (step / steps)
            threshold = current.score + temperature * np.log(self.rng.random())
            challenger = self._raced(self._neighbour(current.layout), threshold)
            if challenger is not None:
                current = challenger
                elite = sorted([*elite, current], key=lambda c: -c.score)[:6]
            elif step % 2 and current.trials.size < _MOST_TRIALS:
                self._try(current, _RUNGS[0])
            progress()
        for finalist in elite:
            self._try(finalist, _MOST_TRIALS)
        return max(elite, key=lambda c: c.score).layout

    def _begun(self) -> Candidate:
        """Return the best of many layouts with the published optimum, by successive halving."""
        field = [self._tried(self._bent(), _RUNGS[0]) for _ in range(_STARTS)]
        while len(field) > 1:
            field = sorted(field, key=lambda c: -c.score)[: max(len(field) // 4, 1)]
            for candidate in field:
                self._try(candidate, 3 * candidate.trials.size)
        return field[0]

    def _bent(self) -> Layout:
        """Return a layout with the published optimum: random, then bent until the length is right."""
        wanted = path_length(*self.environment.optimum)
        layout, miss = random_layout(self.rng), np.inf
        while miss > 1e-9:
            bent = mutate(layout, self.rng)
            pair = self._optimum(bent)
            if pair is not None and abs(path_length(*pair) - wanted) <= miss:
                layout, miss = bent, abs(path_length(*pair) - wanted)
        return layout

    def _neighbour(self, layout: Layout) -> Layout:
        while True:
            neighbour = mutate(layout, self.rng)
            if self._optimum(neighbour) == self.environment.optimum and self._has_local_optima(neighbour):
                return neighbour

    def _has_local_optima(self, layout: Layout) -> bool:
        obstacles = paint(layout)
        return all(self._screen.leads(obstacles, pair) for pair in self.environment.local_optima)

    def _optimum(self, layout: Layout) -> tuple[int, int] | None:
        if not is_layout(layout):
            return None
        obstacles = paint(layout)
        return self._screen.optimum(obstacles) if is_map(obstacles) else None

    def _raced(self, layout: Layout, threshold: float) -> Candidate | None:
        """Return the candidate if it lasts the race against a threshold, else None."""
        candidate = self._tried(layout, _RUNGS[0])
        for rung, trials in enumerate(_RUNGS):
            if rung:
                self._try(candidate, trials - candidate.trials.size)
            slack = _SLACK / trials if trials != _RUNGS[-1] else 0.0
            if candidate.score < threshold - slack:
                return None
        return candidate

    def _tried(self, layout: Layout, trials: int) -> Candidate:
        aco = self._aco.on(Grid(paint(layout), moves=self.moves))
        outcomes = self._run(aco, trials)
        return Candidate(layout, aco, outcomes, score(self.environment, outcomes))

    def _try(self, candidate: Candidate, trials: int) -> None:
        """Run more trials on a candidate and judge it by all of them."""
        candidate.trials = candidate.trials.joined(self._run(candidate.aco, trials))
        candidate.score = score(self.environment, candidate.trials)

    def _run(self, aco: Solver, trials: int) -> Outcomes:
        seeds: list[int] = self.rng.integers(FRESH_BELOW, 2**63, size=trials).tolist()
        return Outcomes.of(result.curve_pairs for result in aco.trials(seeds))
