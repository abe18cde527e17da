"""Readings: the decisions that the paper leaves open, each taken otherwise alone, and a few together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from acoexp.compare.sample import Sample
from acoexp.grid.grid import Grid
from acoexp_paper.published.tables import ALGOS, TABLES
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.samples import Samples, first_trials
from acoexp_paper.trials.undirected import UndirectedAntCycle, UndirectedDualAntCycle

ENVS = tuple(TABLES.values())
"""Those with published rows; of env1 there are none but Table 3's."""

_OF_DIFFUSION = ("diffusion", "field")
"""Keys that change nothing for standard ACO."""

_UNDIRECTED = {"aco": UndirectedAntCycle(), "pd": UndirectedAntCycle(), "pdg": UndirectedDualAntCycle()}


class Reading(NamedTuple):
    """One way to read the paper.

    Attributes:
        text: Its keys as on the command line.
        values: The same as settings.
        moves: The rule for diagonals; None for each map's own.
        undirected: Whether ants lay pheromone on both ways of an edge.
    """

    text: str
    values: Mapping[str, Any]
    moves: str | None = None
    undirected: bool = False

    def of(self, algo: str) -> dict[str, Any]:
        """Return the settings that it changes for an algorithm; none if it is the same as under the defaults."""
        values = {key: value for key, value in self.values.items() if algo != "aco" or key not in _OF_DIFFUSION}
        return {**values, "update": _UNDIRECTED[algo]} if self.undirected else values

    def on(self, grid: Grid) -> Grid | None:
        """Return a map under its rule for diagonals; None if it is then none of the paper's optimum."""
        if self.moves is None or self.moves == grid.moves:
            return grid
        other = Grid(
            grid.obstacles, start=grid.start, goal=grid.goal, moves=self.moves, name=f"{grid.name}, {self.moves}"
        )
        return other if other.optimum_pair == grid.optimum_pair else None

    def changes(self, algo: str, grid: Grid) -> bool:
        """Return whether it changes anything for an algorithm on a map that it fits."""
        return bool(self.of(algo)) or self.moves not in (None, grid.moves)

    def __add__(self, other: Reading) -> Reading:  # type: ignore[override]
        """Return both together."""
        return Reading(
            f"{self.text} {other.text}",
            {**self.values, **other.values},
            self.moves or other.moves,
            self.undirected or other.undirected,
        )


WALKED, SUM_IN, MEAN_OUT, MAX_OUT = (
    Reading(f"diffusion.source={source}", {"diffusion": {"source": source}})
    for source in ("walked_edge", "sum_in", "mean_out", "max_out")
)
SOURCES = (WALKED, SUM_IN, MEAN_OUT, MAX_OUT)
"""Where else the pheromone that diffuses may come from, the most influential of all decisions."""

CELLS = Reading("pheromone=cells", {"pheromone": "cells"})
LOCK_STEP = Reading("order=lock_step", {"order": "lock_step"})
UNDIRECTED = Reading("undirected deposit", {}, undirected=True)
TAU0 = Reading("tau0=8", {"tau0": 8.0})

READINGS = (
    *SOURCES,
    CELLS,
    LOCK_STEP,
    UNDIRECTED,
    *(Reading(f"map.moves={moves}", {}, moves=moves) for moves in ("free", "no_squeeze", "no_cut")),
    Reading("heuristic.at_goal=1", {"heuristic": {"at_goal": 1.0}}),
    Reading("q=100", {"q": 100.0}),
    TAU0,
    Reading("field.obstacles=nearest", {"field": {"obstacles": "nearest"}}),
    Reading("field.repulsion=100", {"field": {"repulsion": 100.0}}),
    Reading("field.reach=2", {"field": {"reach": 2.0}}),
    WALKED + CELLS,
    WALKED + LOCK_STEP,
    SUM_IN + LOCK_STEP,
    SUM_IN + UNDIRECTED,
)

Maps = dict[str, list[Samples | None]]
"""The samples on each map of each environment with published rows; None where a reading does not fit a map."""


def samples_of_readings(experiment: Experiment) -> Iterator[tuple[Reading, Maps, Mapping[str, Sequence[Samples]]]]:
    """Run all readings on all maps; yield the samples of each, and those of the defaults with the same seeds.

    An algorithm that a reading does not change keeps its samples.
    """
    n = experiment.reading_trials
    default: dict[str, list[Samples]] = {
        env: [{algo: first_trials(samples[algo], n) for algo in ALGOS} for samples in experiment.samples[env]]
        for env in ENVS
    }
    for reading in READINGS:
        yield reading, {env: _on_maps(experiment, reading, env, default[env]) for env in ENVS}, default


def _on_maps(
    experiment: Experiment, reading: Reading, env: str, default: Sequence[Samples]
) -> list[Samples | None]:
    grids = [reading.on(grid) for grid in experiment.maps_of(env)]
    by_algo = {algo: _of_algo(experiment, reading, env, algo, grids) for algo in ALGOS}
    return [
        None if grid is None else {algo: by_algo[algo].get(grid.name, unchanged[algo]) for algo in ALGOS}
        for grid, unchanged in zip(grids, default, strict=True)
    ]


def _of_algo(
    experiment: Experiment, reading: Reading, env: str, algo: str, grids: Sequence[Grid | None]
) -> dict[str, Sample]:
    """Return the samples on the maps for which a reading changes something for an algorithm, by the map's name."""
    own = experiment.maps_of(env)
    changed = [new for new, old in zip(grids, own, strict=True) if new is not None and reading.changes(algo, old)]
    if not changed:
        return {}
    settings = experiment.settings(algo, reading.of(algo))
    samples = experiment.unkept(env, settings, changed, experiment.reading_trials, reading.text)
    return {sample.map: sample for sample in samples}


def trials_of_readings(experiment: Experiment) -> int:
    """Return how many trials all readings need."""
    return experiment.reading_trials * sum(
        reading.changes(algo, grid)
        for reading in READINGS
        for env in ENVS
        for grid in experiment.maps_of(env)
        if reading.on(grid) is not None
        for algo in ALGOS
    )
