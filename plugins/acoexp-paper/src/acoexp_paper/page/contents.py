"""The whole report: its sections in their order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from importlib.metadata import version

from acoexp.compare.measures import configuration_row
from acoexp.compare.tables import success_table
from acoexp.report.table import Table
from acoexp_paper.claims.findings import Findings
from acoexp_paper.page.averages import averages, trial_tables
from acoexp_paper.page.claims import claims
from acoexp_paper.page.document import Document, Figure, Numbers, Section
from acoexp_paper.page.method import audit, method
from acoexp_paper.page.readings import readings
from acoexp_paper.page.summary import summary
from acoexp_paper.published.tables import TITLES
from acoexp_paper.trials.experiment import Experiment

TITLE = (
    "Liu et al. 2017, an improved ant colony algorithm for robot path planning: what reproduces and what does not"
)


def document(found: Findings, captions: Mapping[str, str]) -> Document:
    """Return the report.

    Args:
        found: What was found.
        captions: The caption of each figure, by the name of its files.
    """
    experiment = found.experiment
    sections = [
        Section("Summary", summary(found)),
        Section("Tables 1 to 3", trial_tables(experiment)),
        Section("The averages", averages(found)),
        Section("The claims", claims(found.claims)),
        Section("Success and running time", [Numbers("success", _success(experiment))]),
        Section("Figures", [Figure(name, caption) for name, caption in captions.items()]),
        Section("Interpretations", readings(found)),
        Section("Audit of the paper", audit()),
        Section("Maps and method", method(experiment)),
    ]
    return Document(TITLE, _lead(experiment), sections)


def _lead(experiment: Experiment) -> str:
    own = experiment.context.own_settings
    changed = f" Other than in the paper: {', '.join(f'{k}={v}' for k, v in own.items())}." if own else ""
    return (
        f"Liu, Yang, Liu, Tian, Gao, Soft Computing 21 (2017), simulated anew with acoexp {version('acoexp')}: "
        f"{experiment.trials} trials per algorithm and map, seeds 0 to {experiment.trials - 1} for all, beside "
        f"the ten that the paper averages over.{changed}"
    )


def _success(experiment: Experiment) -> Table:
    rows = [
        configuration_row(replace(sample, configuration=TITLES[algo]))
        for samples in experiment.main.values()
        for algo, sample in samples.items()
    ]
    return success_table(rows)._replace(title="Success and expected running time.")
