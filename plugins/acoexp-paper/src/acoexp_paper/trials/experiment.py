"""The experiment: which trials the report asks for, on which maps; run where they are not in the store."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
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
from acoexp_paper.published.tables import ENVIRONMENTS
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
    def _trials(self) -> dict[str, dict[str, Trials]]:
        return {
            env: {algo: self._run(algo, {}, grid, self.trials) for algo in ENVIRONMENTS[env].algos}
            for env, grid in self.maps.items()
        }

    @cached_property
    def main(self) -> dict[str, Samples]:
        """The samples on each environment's own map."""
        return {
            env: {algo: self._measured(env, algo, {}, self.maps[env], trials) for algo, trials in by_algo.items()}
            for env, by_algo in self._trials.items()
        }

    def lost_per_cycle(self, env: str) -> dict[str, Values]:
        """Return, by algorithm, the mean number of ants lost in each cycle on a map, float[iterations]."""
        return {algo: trials.lost_ants.mean(axis=0) for algo, trials in self._trials[env].items()}

    @cached_property
    def samples(self) -> dict[str, list[Samples]]:
        """The samples on all maps of each environment, in the order of :meth:`maps_of`."""
        return {
            env: [
                self.main[env],
                *(
                    {
                        algo: self.varied(env, algo, {}, grid, self.ensemble_trials)
                        for algo in ENVIRONMENTS[env].algos
                    }
                    for grid in self.further_maps(env)
                ),
            ]
            for env in self.maps
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

    def varied(self, env: str, algo: str, values: Mapping[str, Any], grid: Grid, trials: int) -> Sample:
        """Return so many trials of an algorithm on a map, with some values changed."""
        return self._measured(env, algo, values, grid, self._run(algo, values, grid, trials))

    @property
    def size(self) -> int:
        """How many trials there are on the environments' maps and on the further ones."""
        return sum(
            len(ENVIRONMENTS[env].algos) * (self.trials + self.ensemble_trials * len(self.further_maps(env)))
            for env in self.maps
        )

    def _measured(self, env: str, algo: str, values: Mapping[str, Any], grid: Grid, trials: Trials) -> Sample:
        sample = measured(algo, grid, trials)
        if not ENVIRONMENTS[env].shows_pheromone:
            return sample
        return with_concentration(sample, grid, self.settings(algo, values))

    def _run(self, algo: str, values: Mapping[str, Any], grid: Grid, trials: int) -> Trials:
        batch = f"{algo} on {grid.name}{''.join(f', {key}={value}' for key, value in values.items())}"
        return self.context.run(self.settings(algo, values), grid, parse_seeds(f"0-{trials - 1}"), batch)
