"""The experiment: which trials the report asks for, on which maps; run where they are not in the store."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

from acoexp.compare.measures import measured
from acoexp.compare.sample import Sample
from acoexp.compare.statistics import Values
from acoexp.grid.grid import Grid
from acoexp.maps.ensemble import ensemble
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver
from acoexp.trial.threads import check_threads
from acoexp.trial.trials import Trials
from acoexp_paper.published.tables import ENVIRONMENTS, TITLES
from acoexp_paper.trials.concentration import with_concentration
from acoexp_paper.trials.samples import Samples


@dataclass(frozen=True)
class Experiment:
    """All trials behind the report: one set for an algorithm and a map, whatever is asked of them.

    Attributes:
        context: Runs trials.
        maps: The map of each environment.
        given: Environments whose true map the user gave; no other map counts for them.
        trials: Trials of each algorithm on these maps, seeds 0 up.
        ensemble_trials: Trials of each algorithm on each map of the ensembles; 0 leaves these out.
        reading_trials: Trials of each algorithm on every map under each other reading of the paper; 0 leaves
            these out.
    """

    context: Context
    maps: Mapping[str, Grid]
    given: frozenset[str]
    trials: int
    ensemble_trials: int
    reading_trials: int = 0

    @cached_property
    def _settings(self) -> dict[str, Settings]:
        return {algo: self.settings(algo, {}) for algo in TITLES}

    @cached_property
    def _trials(self) -> dict[str, dict[str, Trials]]:
        return {
            env: {algo: self._run(self._settings[algo], grid, self.trials) for algo in ENVIRONMENTS[env].algos}
            for env, grid in self.maps.items()
        }

    @cached_property
    def main(self) -> dict[str, Samples]:
        """The samples on each environment's own map."""
        return {
            env: {
                algo: _measured(env, self._settings[algo], self.maps[env], trials)
                for algo, trials in by_algo.items()
            }
            for env, by_algo in self._trials.items()
        }

    def lost_per_cycle(self, env: str) -> dict[str, Values]:
        """Return, by algorithm, the mean number of ants lost in each cycle on a map, float[iterations]."""
        return {algo: trials.lost_ants.mean(axis=0) for algo, trials in self._trials[env].items()}

    @cached_property
    def samples(self) -> dict[str, list[Samples]]:
        """The samples on all maps of each environment, in the order of :meth:`maps_of`."""
        return {
            env: [self.main[env], *map(partial(self._further, env), self.further_maps(env))] for env in self.maps
        }

    def _further(self, env: str, grid: Grid) -> Samples:
        return {
            algo: _measured(env, settings, grid, self._run(settings, grid, self.ensemble_trials))
            for algo, settings in self._settings.items()
            if algo in ENVIRONMENTS[env].algos
        }

    def maps_of(self, env: str) -> list[Grid]:
        """Return all maps of an environment, its own map first."""
        return [self.maps[env], *self.further_maps(env)]

    def further_maps(self, env: str) -> list[Grid]:
        """Return the maps of an environment's ensemble that are to be run."""
        return [] if env in self.given or not self.ensemble_trials else ensemble(env)

    def settings(self, algo: str, values: Mapping[str, Any]) -> Settings:
        """Return an algorithm's settings with some values changed, on top of the command line's own."""
        own = self.context.own_settings
        merged = {**own, **values}
        if "field" in own and "field" in values:
            merged["field"] = {**own["field"], **values["field"]}
        return resolve(algo, merged)

    def unkept(self, env: str, settings: Settings, grids: Sequence[Grid], trials: int, text: str) -> list[Sample]:
        """Return a few trials on each of some maps, seeds 0 up; to keep them, too, would take as long again.

        Args:
            env: The environment of the maps.
            settings: Of the trials.
            grids: The maps.
            trials: How many on each map.
            text: What is shown while they run.
        """
        solver = Solver(grids[0], settings)

        def sample(grid: Grid) -> Sample:
            return _measured(env, settings, grid, Trials.of(list(solver.on(grid).trials(range(trials)))))

        with ThreadPoolExecutor(check_threads(None)) as pool:
            samples = list(pool.map(sample, grids))
        self.context.show(f"{settings.label} on {env}, {text}", trials * len(grids))
        return samples

    @property
    def size(self) -> int:
        """How many trials there are on the environments' maps and on the further ones."""
        return sum(
            len(ENVIRONMENTS[env].algos) * (self.trials + self.ensemble_trials * len(self.further_maps(env)))
            for env in self.maps
        )

    def _run(self, settings: Settings, grid: Grid, trials: int) -> Trials:
        return self.context.run(settings, grid, parse_seeds(f"0-{trials - 1}"), f"{settings.label} on {grid.name}")


def _measured(env: str, settings: Settings, grid: Grid, trials: Trials) -> Sample:
    sample = measured(settings.label, grid, trials)
    return with_concentration(sample, grid, settings) if ENVIRONMENTS[env].shows_pheromone else sample
