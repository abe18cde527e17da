"""All figures of the report, by the name of their files, each with its caption."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from matplotlib.figure import Figure

from acoexp.result import Result
from acoexp.solver import Solver
from acoexp_paper.experiment import Experiment
from acoexp_paper.figures.curves import draw_curves
from acoexp_paper.figures.drawing import save
from acoexp_paper.figures.effects import draw_iterations, draw_lengths, draw_lost
from acoexp_paper.figures.maps import draw_fields, draw_paths, length_of
from acoexp_paper.figures.pheromone import draw_pheromone
from acoexp_paper.published import TITLES

SEED = 0
"""Of every figure that shows a single trial."""

_TRIES = 1000
_AS_WALKED, _OPTIMISED = 51.1127, 41.4558


def save_figures(experiment: Experiment, folder: Path) -> tuple[dict[str, str], dict[str, str]]:
    """Write all figures; return their SVG texts and their captions, by name."""
    drawings, captions = {}, {}
    for name, figure, caption in sorted(_figures(experiment), key=lambda drawn: drawn[0]):
        drawings[name], captions[name] = save(figure, folder, name), caption
    return drawings, captions


def _figures(experiment: Experiment) -> Iterator[tuple[str, Figure, str]]:
    fig13, env2 = experiment.maps["fig13"], experiment.maps["env2"]
    samples = experiment.main["fig13"]
    trials = samples["aco"].found.size
    yield (
        "fig01",
        draw_fields(dict(experiment.maps), experiment.settings("pd", {}).field),
        (
            "Fig. 1 on each map. Direction of the resultant force of the potential field on every free cell; the "
            "dot is the start, the star the goal. Blue, dark: pheromone diffuses along it. Orange: the move "
            "along it is not allowed, so nothing diffuses."
        ),
    )
    for name, algo in (("fig07", "aco"), ("fig08", "pd"), ("fig12", "pdg")):
        yield (
            name,
            draw_pheromone(fig13, experiment.settings(algo, {}), SEED),
            (
                f"Fig. {int(name[3:])}. Pheromone distribution of {TITLES[algo]} after the cycles 6, 8 and 10 of "
                f"seed {SEED}: sum over the edges into each cell, as a share of the highest (log scale); "
                "obstacles are grey."
            ),
        )
    settings = experiment.settings("aco", {})
    yield (
        "fig09",
        draw_lost(experiment.lost_per_cycle("fig13"), settings.scalars.ants),
        (
            f"Fig. 9. Comparison of the numbers of lost ants: mean per cycle over {trials} trials (the paper does "
            "not name its axes)."
        ),
    )
    yield (
        "fig10",
        draw_iterations(samples),
        (
            f"Fig. 10. Comparison of the iterations: share of {trials} trials that have found the optimum by each "
            "cycle."
        ),
    )
    yield (
        "fig11",
        draw_lengths(samples),
        (f"Fig. 11. Comparison of the paths: share of {trials} trials that converge to each length."),
    )
    ant = _one_ant(experiment)
    yield (
        "fig13",
        draw_paths([(f"one ant, first cycle, seed {ant.seed}", ant)]),
        (
            "Fig. 13. Local path optimisation: the path of one ant of ACO-PDG's first cycle as it was walked, "
            f"and after the geometric optimisation. Of {_TRIES} ants, it is the one whose lengths come nearest to "
            f"the paper's, {_AS_WALKED} and {_OPTIMISED}."
        ),
    )
    yield (
        "fig14",
        draw_paths([(f"best of the run, seed {SEED}", _best(experiment, "fig13"))]),
        (
            "Fig. 14. Simulation diagram of path planning: the best path of a run of ACO-PDG, as it was walked "
            "and optimised."
        ),
    )
    yield "fig16", draw_curves(samples), _curves_caption(16, fig13.name, trials)
    yield (
        "fig17",
        draw_paths([(f"best of the run, seed {SEED}", _best(experiment, "env2"))]),
        ("Fig. 17. Simulation diagram of path planning in environment 2: the best path of a run of ACO-PDG."),
    )
    yield "fig18", draw_curves(experiment.main["env2"]), _curves_caption(18, env2.name, trials)


def _curves_caption(number: int, name: str, trials: int) -> str:
    return (
        f"Fig. {number}. Convergence curves of a. standard ACO, b. ACO-PD, c. ACO-PDG on {name}: ten trials, and "
        f"median and quartiles of {trials}."
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
