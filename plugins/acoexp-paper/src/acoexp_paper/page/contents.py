"""The whole report: its sections in their order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from acoexp.compare.measures import configuration_row
from acoexp.compare.tables import success_table
from acoexp.report.table import Table
from acoexp_paper.claims.findings import Findings
from acoexp_paper.page.averages import averages, trial_tables
from acoexp_paper.page.claims import claims
from acoexp_paper.page.document import Document, Figure, Numbers, Section, Text, numbered
from acoexp_paper.page.maps import fits, maps
from acoexp_paper.page.method import audit, method
from acoexp_paper.page.provenance import provenance
from acoexp_paper.page.readings import readings
from acoexp_paper.page.references import references
from acoexp_paper.page.summary import summary
from acoexp_paper.published.rows import PRINTED_EVENTS
from acoexp_paper.published.tables import TITLES, TRIALS, performance
from acoexp_paper.trials.experiment import Experiment

TITLE = "Liu et al. 2017, an improved ant colony algorithm for robot path planning, run again"

_FIGURES = (
    "The paper's own pictures are not available to us. These are drawn of our trials; whatever its tables and "
    "its text print of the same stands beside them."
)
_NAMES = (
    "ACO-PD is standard ACO with pheromone that diffuses along a potential field, ACO-PDG has a geometric "
    "optimiser of paths on top, ACO-PF is an older rival. fig13 stands for the environment of Fig. 13 and Table "
    "1, env2 that of Fig. 17 and Table 2, env1 environment 1 of Table 3."
)


def document(found: Findings, captions: Mapping[str, tuple[str, str]]) -> Document:
    """Return the report.

    Args:
        found: What was found.
        captions: The title and the caption of each figure, by the name of its files.
    """
    experiment = found.experiment
    figures = {name: Figure(name, *texts) for name, texts in captions.items()}
    papers = [figure for name, figure in figures.items() if name.startswith("fig")]
    pictures = [figure for name, figure in figures.items() if not name.startswith("fig")]
    sections = [
        Section("Summary", summary(found)),
        Section("The claims", claims(found.claims)),
        Section("Tables 1 to 3", trial_tables(experiment)),
        Section("Figures", [Text(_FIGURES), *papers]),
        Section("The averages", averages(found), "Each published average beside ours"),
        Section("Success and running time", [Numbers("success", _success(experiment))]),
        Section("Interpretations", readings(found), "What the paper leaves open, read otherwise"),
        Section("Audit of the paper", audit(), "Where its tables, text and equations contradict each other"),
        Section("Maps and method", [*method(experiment), *maps(experiment), *pictures]),
        Section("How well the maps fit", fits(experiment), "Each map, those of the ensembles too"),
        Section("What this was made with", provenance(experiment)),
        Section("References", references()),
    ]
    return numbered(Document(TITLE, _lead(experiment), sections))


def _lead(experiment: Experiment) -> str:
    own = experiment.context.own_settings
    changed = f" Other than in the paper: {', '.join(f'{k}={v}' for k, v in own.items())}." if own else ""
    further = f" and {experiment.ensemble_trials} on each further one" if experiment.ensemble_trials else ""
    return (
        f"Liu, Yang, Liu, Tian, Gao, Soft Computing 21 (2017): {experiment.trials} trials of each algorithm on "
        f"each environment's map{further}, with the same seeds for all, beside the ten that the paper averages "
        f"over. {_NAMES}{changed}"
    )


def _success(experiment: Experiment) -> Table:
    places = [(env, algo) for env, samples in experiment.main.items() for algo in samples]
    table = success_table(
        [
            configuration_row(replace(experiment.main[env][algo], configuration=TITLES[algo]))
            for env, algo in places
        ]
    )
    return Table(
        "Success and expected running time.",
        f"{table.note} Paper: trials of its ten that found it.",
        ["map", "algorithm", *table.headings[2:], "paper"],
        [[*row, f"{_found(env, algo)}/{TRIALS}"] for row, (env, algo) in zip(table.rows, places, strict=True)],
    )


def _found(env: str, algo: str) -> int:
    """Return how many of the ten published trials found the optimum, by the rows or else by Table 3."""
    rows = PRINTED_EVENTS["found"](env, algo)
    return int(performance(env, algo, "n_c") if rows is None else rows.sum())
