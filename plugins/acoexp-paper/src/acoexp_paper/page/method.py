"""The sections on what the numbers rest on: the method, and the audit of the paper's own numbers."""

from __future__ import annotations

from acoexp.report.table import Table
from acoexp_paper.page.document import Block, Bullets, Heading, Numbers, Text
from acoexp_paper.page.formats import number
from acoexp_paper.published.audit import EQUATIONS, Recomputed, contradictions, impossible_rows, recomputed
from acoexp_paper.published.tables import TITLES
from acoexp_paper.trials.experiment import Experiment


def method(experiment: Experiment) -> list[Block]:
    """Return the settings, in words."""
    settings = experiment.settings("pdg", {}).scalars
    return [
        Text(
            f"alpha = {settings.alpha:g}, beta = {settings.beta:g}, rho = {settings.rho:g}, {settings.ants} ants, "
            f"{settings.iterations} cycles, Q = {settings.q:g}, tau0 = {settings.tau0:g}. Tests are "
            "scipy's; intervals are at 95 %; resampling has a fixed seed."
        )
    ]


def audit() -> list[Block]:
    """Return what the paper's own tables, text and equations contradict."""
    note = "Averages as printed, of the rows as printed, and of the rows with their misprints mended."
    headings = ["table", "algorithm", "column", "printed", "of the rows", "of the mended rows", "as printed"]
    rows = [_recomputed(row) for row in recomputed()]
    return [
        Numbers("audit", Table("The paper's averages, recomputed.", note, headings, rows)),
        Heading("Rows that cannot be, or not as the text has it"),
        Bullets(list(impossible_rows())),
        Heading("Where the text and the tables disagree"),
        Bullets(contradictions()),
        Heading("Equations, as they must be meant and are computed here"),
        Bullets([f"{equation}. {correction}" for equation, correction in EQUATIONS.items()]),
    ]


def _recomputed(row: Recomputed) -> list[str]:
    numbers = (number(row.column, value) for value in (row.printed, row.of_rows, row.of_mended))
    return [str(row.table), TITLES[row.algo], row.column, *numbers, "differs" if row.differs else "agrees"]
