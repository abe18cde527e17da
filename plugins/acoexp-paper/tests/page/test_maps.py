"""The sections on maps."""

from __future__ import annotations

from dataclasses import replace

from acoexp_paper.page.document import Bullets
from acoexp_paper.page.maps import fits, maps
from acoexp_paper.trials.experiment import Experiment
from small import MAPS, TRIALS

from acoexp.grid.grid import Grid


def test_each_map_stands_with_its_source_optimum_and_further_maps(experiment: Experiment) -> None:
    given = replace(experiment, given=frozenset({"fig13"}))
    rows = {row[0]: row for row in maps(given)[0].table.rows}
    digest = experiment.maps["fig13"].digest
    assert rows["fig13"][2:] == ["given", experiment.maps["fig13"].moves, "30.3848", digest, "0"]
    assert rows["env1"][1:3] + rows["env1"][-1:] == ["environment 1 of Table 3", "reconstruction", str(MAPS)]


def test_the_fit_of_a_map_is_said_where_it_is_known(experiment: Experiment) -> None:
    said = [f"{env}: {grid.metadata['fit']}" for env, grid in experiment.maps.items() if "fit" in grid.metadata]
    assert said
    assert maps(experiment)[1] == Bullets(said)
    unfitted = {"fig13": Grid(experiment.maps["fig13"].obstacles)}
    assert len(maps(replace(experiment, maps=unfitted))) == 1


def test_every_map_stands_beside_what_is_published(experiment: Experiment) -> None:
    (block,) = fits(experiment)
    rows = {row[0]: row for row in block.table.rows}
    assert rows["fig13, published"][3:] == ["-59.6", "10", "100%", "30%", "11.0", "28.1"]
    assert rows["env2, published"][4:] == ["10", "50%", "20%", "4.7", "18.0"]
    sample, grid = experiment.main["fig13"]["aco"], experiment.maps["fig13"]
    assert rows["fig13"][3:6] == [
        f"{float(grid.metadata['score']):.1f}", str(TRIALS), f"{sample.found.mean():.0%}",
    ]  # fmt: skip
    assert rows["fig13"][-2] == f"{sample.features['x1'].mean():.1f}"
    assert len(rows) == 2 * (2 + MAPS)
