"""All figures: their names, their captions, and which trials they show. Solvers and files are made up."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from acoexp_paper.figures import everything, pheromone, single
from acoexp_paper.figures.everything import save_figures
from acoexp_paper.trials.experiment import Experiment
from matplotlib.figure import Figure
from small import FIGURES, TRIALS

from acoexp.grid.grid import Grid
from acoexp.trial.settings import Settings

NEAREST = 17


class MadeSolver:
    """Ants that walk to and fro, and whose paths are then said to be as long as that of the paper's Fig. 13."""

    def __init__(self, grid: Grid, settings: Settings) -> None:
        self.grid, self.alone = grid, (settings.scalars.ants, settings.scalars.iterations) == (1, 1)

    def solve(self, seed: int) -> SimpleNamespace:
        moves = {NEAREST - 1: 41, NEAREST: 51}.get(seed, 70) if self.alone else 30
        path = np.array([(0, step % 2) for step in range(moves + 1)])
        raw = None if seed == NEAREST + 1 else path  # lost
        return SimpleNamespace(
            seed=seed, grid=self.grid, raw_path=raw, path=path, length=41.4558, found_optimum=True
        )

    def solve_many(self, seeds: Iterable[int], threads: int) -> list[SimpleNamespace]:
        return [self.solve(seed) for seed in seeds]

    def pheromone(self, seed: int) -> np.ndarray:
        return np.ones((*self.grid.shape, 8))


@pytest.fixture(scope="module")
def figures() -> dict[str, Figure]:
    """The figures that were drawn, by name."""
    return {}


@pytest.fixture(scope="module", autouse=True)
def captions(experiment: Experiment, figures: dict[str, Figure]) -> dict[str, tuple[str, str]]:
    """Their titles and captions."""

    def keep(figure: Figure, folder: Path, name: str) -> str:
        figures[name] = figure
        return f"<svg>{name}</svg>"

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(everything, "save", keep)
        patch.setattr(single, "Solver", MadeSolver)
        patch.setattr(pheromone, "Solver", MadeSolver)
        drawings, captions = save_figures(experiment, Path())
    assert drawings == {name: f"<svg>{name}</svg>" for name in captions}
    return captions


def test_figures_are_named_and_ordered_by_their_numbers_in_the_paper(captions: dict[str, tuple[str, str]]) -> None:
    assert list(captions) == FIGURES
    for name, (title, _) in captions.items():
        assert not name.startswith("fig") or re.match(rf"Fig\. {int(name[3:])}\b", title)


@pytest.mark.parametrize("name", ["fig09", "fig10", "fig11", "fig16", "fig18"])
def test_a_caption_says_of_how_many_trials(captions: dict[str, tuple[str, str]], name: str) -> None:
    assert re.search(rf"\b{TRIALS}\b", captions[name][1])


@pytest.mark.parametrize(("name", "algo"), [("fig07", "Standard ACO"), ("fig08", "ACO-PD"), ("fig12", "ACO-PDG")])
def test_pheromone_is_that_of_the_algorithm_in_the_caption(
    captions: dict[str, tuple[str, str]], name: str, algo: str
) -> None:
    assert f"distribution of {algo} after the cycles 6, 8 and 10" in captions[name][0]
    assert captions[name][1].startswith("Seed 0 on fig13")


def test_the_ant_of_fig_13_is_the_one_whose_lengths_come_nearest_to_the_papers(figures: dict[str, Figure]) -> None:
    assert figures["fig13"].axes[0].get_title() == f"one ant, first cycle, seed {NEAREST}"


@pytest.mark.parametrize(("name", "env"), [("fig14", "fig13"), ("fig17", "env2")])
def test_a_best_path_is_drawn_on_its_environments_map(
    experiment: Experiment, figures: dict[str, Figure], name: str, env: str
) -> None:
    (axes,) = figures[name].axes
    obstacles = experiment.maps[env].obstacles
    best = int(np.nanargmin(experiment.main[env]["pdg"].features["l1"]))
    assert axes.get_title() == f"best of the run, seed {best}"
    filled = ~np.ma.getmaskarray(axes.collections[0].get_array())
    np.testing.assert_array_equal(filled.reshape(obstacles.shape), obstacles)


@pytest.mark.parametrize(("name", "env"), [("fig16", "fig13"), ("fig18", "env2")])
def test_curves_are_those_of_the_map_in_the_caption(
    experiment: Experiment, figures: dict[str, Figure], captions: dict[str, tuple[str, str]], name: str, env: str
) -> None:
    first = figures[name].axes[0].lines[0]
    np.testing.assert_array_equal(first.get_ydata(), experiment.main[env]["aco"].curves[0])
    assert captions[name][0].endswith(f"on {env}")


def test_the_border_is_said_not_to_repel(captions: dict[str, tuple[str, str]]) -> None:
    assert "Obstacle cells repel, the map's border does not" in captions["fig01"][1]


def test_a_best_path_that_is_not_the_optimum_is_said_not_to_be_it() -> None:
    assert "no seed found the published optimum, 30.3848" in everything._which("fig13", found=False)
