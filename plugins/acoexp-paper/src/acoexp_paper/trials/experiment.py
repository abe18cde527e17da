"""The experiment: which trials the report asks for, on which maps; run where they are not in the store."""

from __future__ import annotations

from collections.abc import Mapping
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
                algo: _measured(env, algo, self._settings[algo], self.maps[env], trials)
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
        algos = ENVIRONMENTS[env].algos
        return {algo: self.sample(env, algo, self._settings[algo], grid, self.ensemble_trials) for algo in algos}

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

    def sample(self, env: str, algo: str, settings: Settings, grid: Grid, trials: int, text: str = "") -> Sample:
        """Return so many trials of an algorithm on a map of an environment.

        Args:
            env: The environment.
            algo: The algorithm.
            settings: Its settings, the defaults or others.
            grid: The map.
            trials: How many, seeds 0 up.
            text: What is said of the settings while the trials run.
        """
        return _measured(env, algo, settings, grid, self._run(settings, grid, trials, text))

    @property
    def size(self) -> int:
        """How many trials there are on the environments' maps and on the further ones."""
        return sum(
            len(ENVIRONMENTS[env].algos) * (self.trials + self.ensemble_trials * len(self.further_maps(env)))
            for env in self.maps
        )

    def _run(self, settings: Settings, grid: Grid, trials: int, text: str = "") -> Trials:
        batch = f"{settings.label} on {grid.name}{text and f', {text}'}"
        return self.context.run(settings, grid, parse_seeds(f"0-{trials - 1}"), batch)


def _measured(env: str, algo: str, settings: Settings, grid: Grid, trials: Trials) -> Sample:
    sample = measured(algo, grid, trials)
    return with_concentration(sample, grid, settings) if ENVIRONMENTS[env].shows_pheromone else sample
