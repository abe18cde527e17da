"""The sections on the maps: those of the environments, and how well each of their ensembles' fits."""

from __future__ import annotations

from collections.abc import Iterator

from acoexp.compare.sample import Sample
from acoexp.grid.grid import Grid
from acoexp.report.table import Table
from acoexp_paper.claims.likelihood import of_themselves
from acoexp_paper.claims.means import mean
from acoexp_paper.page.document import Block, Bullets, Numbers
from acoexp_paper.page.formats import number
from acoexp_paper.published.tables import ENVIRONMENTS, TABLES, average, mended
from acoexp_paper.trials.experiment import Experiment

_MAPS = (
    "The exact optimum is by Dijkstra's algorithm, and is the published one, as on every further map, those of "
    "the ensemble. Diagonal moves past corners of obstacles: free allows all, no_squeeze none between two "
    "obstacles, no_cut none past any."
)
_FITS = (
    "Standard ACO on each map beside the ten published trials, the only ones that the search for the maps looked "
    "at. Log-likelihood: of these ten under the simulated ones, on seeds that the search did not see; higher is "
    "better, a point or two is chance; in the published row under themselves, which is no bound. Finds, keeps: "
    "trials that find the optimum, that converge to it."
)


def maps(experiment: Experiment) -> list[Block]:
    """Return the maps of the environments, and how well standard ACO on them fits, in words."""
    headings = ["map", "environment", "source", "diagonals", "exact optimum", "digest", "further maps"]
    rows = [_map(experiment, env, grid) for env, grid in experiment.maps.items()]
    fits = [f"{env}: {grid.metadata['fit']}" for env, grid in experiment.maps.items() if "fit" in grid.metadata]
    table = Numbers("maps", Table("The environments' maps.", _MAPS, headings, rows))
    return [table, Bullets(fits)] if fits else [table]


def _map(experiment: Experiment, env: str, grid: Grid) -> list[str]:
    return [
        env,
        ENVIRONMENTS[env].title,
        "given" if env in experiment.given else "reconstruction",
        grid.moves,
        f"{grid.optimum:.4f}",
        grid.digest,
        str(len(experiment.further_maps(env))),
    ]


def fits(experiment: Experiment) -> list[Block]:
    """Return how well each map fits, those of the ensembles too, of the environments with published trials."""
    headings = [
        "map",
        "diagonals",
        "obstacles",
        "log-likelihood",
        "trials",
        "finds",
        "keeps",
        "mean x1",
        "mean x3",
    ]
    rows = [row for table, env in TABLES.items() for row in _fits(experiment, table, env)]
    return [Numbers("fits", Table("How well each map fits.", _FITS, headings, rows))]


def _fits(experiment: Experiment, table: int, env: str) -> Iterator[list[str]]:
    l1, l2 = (mended(table, "aco", name) == round(ENVIRONMENTS[env].optimum, 4) for name in ("l1", "l2"))
    means = [number(name, average(table, "aco", name)) for name in ("x1", "x3")]
    yield [
        f"{env}, published",
        "",
        "",
        f"{of_themselves(env):.1f}",
        str(l1.size),
        f"{l1.mean():.0%}",
        f"{l2.mean():.0%}",
        *means,
    ]
    for grid, samples in zip(experiment.maps_of(env), experiment.samples[env], strict=True):
        yield _fit(grid, samples["aco"])


def _fit(grid: Grid, sample: Sample) -> list[str]:
    kept = sample.features["l2"] == sample.optimum
    return [
        grid.name,
        grid.moves,
        f"{grid.obstacles.mean():.0%}",
        f"{float(grid.metadata['score']):.1f}" if "score" in grid.metadata else "-",
        str(sample.found.size),
        f"{sample.found.mean():.0%}",
        f"{kept.mean():.0%}",
        *(number(name, mean(sample.features[name])) for name in ("x1", "x3")),
    ]
