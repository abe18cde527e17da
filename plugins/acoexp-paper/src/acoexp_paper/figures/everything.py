"""All figures of the report, by the name of their files, each with its caption."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from pathlib import Path

from matplotlib.figure import Figure

from acoexp.trial.result import Result
from acoexp.trial.solver import Solver
from acoexp_paper.figures.curves import draw_curves
from acoexp_paper.figures.drawing import save
from acoexp_paper.figures.effects import draw_iterations, draw_lengths, draw_lost
from acoexp_paper.figures.maps import draw_fields, draw_path, length_of
from acoexp_paper.figures.pheromone import draw_pheromone
from acoexp_paper.published.tables import TITLES
from acoexp_paper.trials.experiment import Experiment

SEED = 0
"""Of every figure that shows a single trial."""

_TRIES = 1000
_AS_WALKED, _OPTIMISED = 51.1127, 41.4558

Drawn = tuple[str, Figure, str]
"""The name of a figure's files, the figure, and its caption."""


def save_figures(experiment: Experiment, folder: Path) -> tuple[dict[str, str], dict[str, str]]:
    """Write all figures; return their SVG texts and their captions, by name."""
    figures = (_field, _pheromone, _effects, _paths, _curves)
    drawn = chain.from_iterable(draw(experiment) for draw in figures)
    drawings, captions = {}, {}
    for name, figure, caption in sorted(drawn, key=lambda one: one[0]):
        drawings[name], captions[name] = save(figure, folder, name), caption
    return drawings, captions


def _field(experiment: Experiment) -> Iterator[Drawn]:
    yield (
        "fig01",
        draw_fields(experiment.maps, experiment.settings("pd", {}).field),
        "Fig. 1 on each map. Direction of the resultant force of the potential field on every free cell; the "
        "dot is the start, the star the goal. Blue, dark: pheromone diffuses along it. Orange: the move "
        "along it is not allowed, so nothing diffuses.",
    )


def _pheromone(experiment: Experiment) -> Iterator[Drawn]:
    for number, algo in ((7, "aco"), (8, "pd"), (12, "pdg")):
        yield (
            f"fig{number:02}",
            draw_pheromone(experiment.maps["fig13"], experiment.settings(algo, {}), SEED),
            f"Fig. {number}. Pheromone distribution of {TITLES[algo]} after the cycles 6, 8 and 10 of "
            f"seed {SEED}: sum over the edges into each cell, as a share of the highest (log scale); "
            "obstacles are grey.",
        )


def _effects(experiment: Experiment) -> Iterator[Drawn]:
    samples, trials = experiment.main["fig13"], experiment.trials
    ants = experiment.settings("aco", {}).scalars.ants
    yield (
        "fig09",
        draw_lost(experiment.lost_per_cycle("fig13"), ants),
        f"Fig. 9. Comparison of the numbers of lost ants: mean per cycle over {trials} trials (the paper does "
        "not name its axes).",
    )
    yield (
        "fig10",
        draw_iterations(samples),
        f"Fig. 10. Comparison of the iterations: share of {trials} trials that have found the optimum by each "
        "cycle.",
    )
    yield (
        "fig11",
        draw_lengths(samples),
        f"Fig. 11. Comparison of the paths: share of {trials} trials that converge to each length.",
    )


def _paths(experiment: Experiment) -> Iterator[Drawn]:
    ant = _one_ant(experiment)
    yield (
        "fig13",
        draw_path(f"one ant, first cycle, seed {ant.seed}", ant),
        "Fig. 13. Local path optimisation: the path of one ant of ACO-PDG's first cycle as it was walked, "
        f"and after the geometric optimisation. Of {_TRIES} ants, it is the one whose lengths come nearest to "
        f"the paper's, {_AS_WALKED} and {_OPTIMISED}.",
    )
    yield (
        "fig14",
        draw_path(f"best of the run, seed {SEED}", _best(experiment, "fig13")),
        "Fig. 14. Simulation diagram of path planning: the best path of a run of ACO-PDG, as it was walked "
        "and optimised.",
    )
    yield (
        "fig17",
        draw_path(f"best of the run, seed {SEED}", _best(experiment, "env2")),
        "Fig. 17. Simulation diagram of path planning in environment 2: the best path of a run of ACO-PDG.",
    )


def _curves(experiment: Experiment) -> Iterator[Drawn]:
    for number, env in ((16, "fig13"), (18, "env2")):
        yield (
            f"fig{number}",
            draw_curves(experiment.main[env]),
            f"Fig. {number}. Convergence curves of a. standard ACO, b. ACO-PD, c. ACO-PDG on "
            f"{experiment.maps[env].name}: ten trials, and median and quartiles of {experiment.trials}.",
        )


def _best(experiment: Experiment, env: str) -> Result:
    return Solver(experiment.maps[env], experiment.settings("pdg", {})).solve(SEED)


def _one_ant(experiment: Experiment) -> Result:
    """Return the ant whose path is most like the one of the paper's Fig. 13, among the first seeds' first ants."""
    settings = experiment.settings("pdg", {})
    alone = replace(settings, scalars=replace(settings.scalars, ants=1, iterations=1))
    results = Solver(experiment.maps["fig13"], alone).solve_many(range(_TRIES), threads=1)
    return min(results, key=lambda result: (_unlike_the_papers(result), result.seed))


def _unlike_the_papers(result: Result) -> float:
    """Return how far, in cells, an ant's path is from the lengths that the paper gives for that of Fig. 13."""
    if result.raw_path is None:
        return math.inf
    return abs(length_of(result.raw_path) - _AS_WALKED) + abs(result.length - _OPTIMISED)
