"""All figures of the report, by the name of their files, each with its title and its caption."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from pathlib import Path

from matplotlib.figure import Figure

from acoexp_paper.figures.curves import draw_curves
from acoexp_paper.figures.drawing import save
from acoexp_paper.figures.effects import draw_iterations, draw_lengths, draw_lost
from acoexp_paper.figures.ensembles import draw_maps
from acoexp_paper.figures.maps import draw_fields, draw_path
from acoexp_paper.figures.pheromone import draw_pheromone
from acoexp_paper.figures.points import draw_points, telling_trial
from acoexp_paper.figures.single import AS_WALKED, OPTIMISED, TRIES, best_run, one_ant
from acoexp_paper.published.tables import ENVIRONMENTS, TITLES
from acoexp_paper.trials.experiment import Experiment

SEED = 0
"""Of the trials whose pheromone is shown."""

Drawn = tuple[str, Figure, str, str]
"""The name of a figure's files, the figure, its title and its caption."""


def save_figures(experiment: Experiment, folder: Path) -> tuple[dict[str, str], dict[str, tuple[str, str]]]:
    """Write all figures, the paper's, then ours; return their SVG texts, and titles and captions, by name."""
    figures = (_field, _pheromone, _effects, _paths, _points, _curves)
    papers = sorted(chain.from_iterable(draw(experiment) for draw in figures), key=lambda one: one[0])
    drawings, captions = {}, {}
    for name, figure, title, caption in chain(papers, _ensembles(experiment)):
        drawings[name], captions[name] = save(figure, folder, name), (title, caption)
    return drawings, captions


def _field(experiment: Experiment) -> Iterator[Drawn]:
    yield (
        "fig01",
        draw_fields(experiment.maps, experiment.settings("pd", {}).field),
        "Fig. 1. Resultant force direction",
        "On every free cell of each environment's map the direction of the potential field's force; the dot is "
        "the start, the star the goal. Blue, dark: pheromone diffuses along it. Orange: the move along it is not "
        "allowed, so nothing diffuses. Obstacle cells repel, the map's border does not, as the paper speaks of "
        "obstacles alone: so arrows along a border, and out of the map, are no error.",
    )


def _pheromone(experiment: Experiment) -> Iterator[Drawn]:
    for number, algo in ((7, "aco"), (8, "pd"), (12, "pdg")):
        yield (
            f"fig{number:02}",
            draw_pheromone(experiment.maps["fig13"], experiment.settings(algo, {}), SEED),
            f"Fig. {number}. Pheromone distribution of {TITLES[algo]} after the cycles 6, 8 and 10",
            f"Seed {SEED} on fig13: sum over the edges into each cell, as a share of the highest (log scale); "
            "obstacles are grey. One trial shows no difference between algorithms: how pheromone gathers in all "
            "of them is among the claims.",
        )


def _effects(experiment: Experiment) -> Iterator[Drawn]:
    samples, trials = experiment.main["fig13"], experiment.trials
    ants = experiment.settings("aco", {}).scalars.ants
    yield (
        "fig09",
        draw_lost(experiment.lost_per_cycle("fig13"), ants),
        "Fig. 9. Comparison of the numbers of lost ants",
        f"Mean per cycle over {trials} trials on fig13. The paper prints no number of lost ants, in words only "
        "that ACO-PD has fewer, and does not name its axes.",
    )
    yield (
        "fig10",
        draw_iterations(samples, 1),
        "Fig. 10. Comparison of the iterations",
        f"Share of {trials} trials on fig13 that have found the optimum by each cycle; dots: the ten published "
        "trials of each algorithm, by x1 of Table 1.",
    )
    yield (
        "fig11",
        draw_lengths(samples, 1),
        "Fig. 11. Comparison of the global optimal paths",
        f"Share of {trials} trials on fig13 that converge to each length; diamonds: the share of the ten "
        "published trials, by l2 of Table 1.",
    )


def _paths(experiment: Experiment) -> Iterator[Drawn]:
    ant, best, best_of_env2 = one_ant(experiment), best_run(experiment, "fig13"), best_run(experiment, "env2")
    yield (
        "fig13",
        draw_path(f"one ant, first cycle, seed {ant.seed}", ant),
        "Fig. 13. Local path optimization",
        "The path of one ant of ACO-PDG's first cycle as it was walked, and after the geometric optimisation. Of "
        f"{TRIES} ants, it is the one whose lengths come nearest to the published {AS_WALKED} and {OPTIMISED}.",
    )
    yield (
        "fig14",
        draw_path(f"best of the run, seed {best.seed}", best),
        "Fig. 14. Simulation diagram of path planning",
        f"The best path of a run of ACO-PDG on fig13: {_which('fig13', best.found_optimum)} As it was walked, "
        f"and as it was optimised. The paper's has the length {OPTIMISED}, which is not the optimum that it "
        "prints, but one ant's path of Fig. 13 after its optimisation.",
    )
    yield (
        "fig17",
        draw_path(f"best of the run, seed {best_of_env2.seed}", best_of_env2),
        "Fig. 17. Simulation diagram of path planning in environment 2",
        f"The best path of a run of ACO-PDG on env2: {_which('env2', best_of_env2.found_optimum)}",
    )


def _which(env: str, found: bool) -> str:
    optimum = f"the published optimum, {ENVIRONMENTS[env].optimum:.4f}"
    if found:
        return f"the first seed that found {optimum}."
    return f"no seed found {optimum}; the first of those with the shortest path."


def _points(experiment: Experiment) -> Iterator[Drawn]:
    sample = experiment.main["fig13"]["aco"]
    trial = telling_trial(sample)
    yield (
        "fig15",
        draw_points(sample, trial),
        "Fig. 15. Feature parameters",
        "x1 is the cycle that first finds the best length of the run, l1; x2 the first that finds it twice in a "
        "row, or else the last that finds it; x3 the one from which the curve stays at the length of convergence, "
        f"l2. Here standard ACO on fig13, seed {trial}; dotted: the optimum.",
    )


def _curves(experiment: Experiment) -> Iterator[Drawn]:
    for number, env, table in ((16, "fig13", 1), (18, "env2", 2)):
        yield (
            f"fig{number}",
            draw_curves(experiment.main[env], table),
            f"Fig. {number}. Convergence curves of a. standard ACO, b. ACO-PD, c. ACO-PDG on {env}",
            f"Ten trials, and median and quartiles of {experiment.trials}. Of the paper's ten, Table {table} "
            "prints where each first found its best length (triangles) and where it settled (squares).",
        )


def _ensembles(experiment: Experiment) -> Iterator[Drawn]:
    for env, grid in experiment.maps.items():
        if further := experiment.further_maps(env):
            scored = not ENVIRONMENTS[env].only_optimum
            fit = (
                "The number is the log-likelihood of the ten published trials of standard ACO (higher is better)"
                if scored
                else "No trial of standard ACO on it is published, so there is no score"
            )
            yield (
                f"maps_{env}",
                draw_maps([grid, *further], scored),
                f"The maps that stand for {ENVIRONMENTS[env].title}",
                f"All have the published optimum, {grid.optimum:.4f}. The first is the environment's map, the "
                f"others are its ensemble; below each name its rule for diagonals. {fit}.",
            )
