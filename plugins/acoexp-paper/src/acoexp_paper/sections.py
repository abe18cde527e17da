"""The sections of the report, from what was found to what is read."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.metadata import version
from typing import NamedTuple

from acoexp.report.measures import cell_row
from acoexp.report.statistics import Estimate
from acoexp.report.tables import Table, interval, success_table
from acoexp_paper import audit
from acoexp_paper.averages import Average, averages
from acoexp_paper.document import Block, Bullets, Document, Figure, Heading, Numbers, Section, Text
from acoexp_paper.experiment import Experiment
from acoexp_paper.published import ENVIRONMENTS, TITLES
from acoexp_paper.reading_tables import interpretations
from acoexp_paper.readings import Outcome, outcomes
from acoexp_paper.summary import summary
from acoexp_paper.trial_tables import trial_tables
from acoexp_paper.verdicts import Judged, judge

TITLE = (
    "Liu et al. 2017, an improved ant colony algorithm for robot path planning: what reproduces and what does not"
)


class Findings(NamedTuple):
    """Everything that was found, in numbers."""

    experiment: Experiment
    averages: list[Average]
    claims: list[Judged]
    readings: list[Outcome]

    @classmethod
    def of(cls, experiment: Experiment) -> Findings:
        """Run what is missing, and look at all of it."""
        readings = outcomes(experiment) if experiment.ensemble_trials else []
        return cls(experiment, averages(experiment), judge(experiment), readings)


def document(found: Findings, captions: Mapping[str, str]) -> Document:
    """Return the report."""
    figures = [Figure(name, caption) for name, caption in captions.items()]
    sections = [
        Section("Summary", summary(found)),
        Section("Tables 1 to 3", [Numbers(name, table) for name, table in trial_tables(found.experiment).items()]),
        Section("The averages", _averages(found)),
        Section("The claims", _claims(found)),
        Section("Success and running time", [Numbers("success", _success(found.experiment))]),
        Section("Figures", figures),
        Section("Interpretations", interpretations(found)),
        Section("Audit of the paper", _audit()),
        Section("Maps and method", _method(found)),
    ]
    return Document(TITLE, _lead(found.experiment), sections)


def _lead(experiment: Experiment) -> str:
    own = experiment.context.own_settings
    changed = f" Other than in the paper: {', '.join(f'{k}={v}' for k, v in own.items())}." if own else ""
    return (
        f"Liu, Yang, Liu, Tian, Gao, Soft Computing 21 (2017), simulated anew with acoexp {version('acoexp')}: "
        f"{experiment.trials} trials per cell, seeds 0 to {experiment.trials - 1} for all, beside the ten that "
        f"the paper averages over.{changed}"
    )


def _averages(found: Findings) -> list[Block]:
    note = (
        "Published averages, of ten trials each, beside ours: of the seeds 0 to 9, and of all "
        f"{found.experiment.trials} trials with the interval in which the mean of ten trials falls in 95 % of "
        "cases (bootstrap). Inside: whether the published average lies in it. Ensemble: the same where the map, "
        "too, is drawn from the ensemble; for env1 that alone counts. x2_last is x2 read as the last cycle with "
        "l1 where l2 differs. Lengths in cells, n_c of ten."
    )
    headings = ["table", "map", "algorithm", "column", "published", "seeds 0-9", "ours", "inside"]
    headings += ["ensemble", "inside (ensemble)"]
    rows = [
        [
            str(row.table), row.map, TITLES[row.algorithm], row.column, _number(row.column, row.published),
            _number(row.column, row.first_ten), _interval(row.column, row.ours), _yes(row.inside),
            "-" if row.ensemble is None else _interval(row.column, row.ensemble), _yes(row.ensemble_inside),
        ]
        for row in found.averages
    ]  # fmt: skip
    return [Numbers("averages", Table("Averages, published and ours.", note, headings, rows))]


def _claims(found: Findings) -> list[Block]:
    note = (
        "Trials with one seed share random numbers, so two algorithms are compared in pairs: A12 is the "
        "probability that the first does better, ties counted half; the odds ratio is above 1 if it succeeds "
        "more often. A trial that misses the optimum ranks behind all that find it. p of comparing claims is "
        "corrected over their family (Holm); claims about one algorithm are their own null hypothesis and are "
        'judged uncorrected. "Every" is held to mean 99 %. Maps: those of the ensemble that support the claim / '
        "show the opposite / neither; over the maps: the mean effect, each map counting once (for odds ratios the "
        "difference in shares). * the maps were fitted to this number."
    )
    headings = ["claim", "where", "map", "test", "p", "effect", "on the map", "maps", "over the maps", "verdict"]
    rows = [_claim_row(judged) for judged in found.claims]
    explain = (
        "A claim holds, or its opposite does, if at least four fifths of the maps say so and none says the "
        "contrary; it depends on the map if some maps support it and others show the opposite, or if between a "
        "fifth and four fifths do either; otherwise it does not hold, which for a comparison means that it was "
        "not shown."
    )
    return [Text(explain), Numbers("claims", Table("Claims of Sects 4 to 6.", note, headings, rows))]


def _claim_row(judged: Judged) -> list[str]:
    claim, finding = judged.claim, judged.finding
    effect = interval(*finding.effect)
    says = judged.says
    return [
        claim.text + (" *" if claim.fitted else ""),
        claim.where,
        claim.map,
        finding.statistic,
        _p(judged.p_holm),
        f"{finding.measure} {effect}",
        judged.on_map or "-",
        f"{says.count(1)} / {says.count(-1)} / {says.count(0)}" if says else "-",
        "-" if judged.over_maps is None else f"{interval(*judged.over_maps.effect)}, p {_p(judged.over_maps.p)}",
        judged.verdict,
    ]


def _success(experiment: Experiment) -> Table:
    rows = [cell_row(sample) for samples in experiment.main.values() for sample in samples.values()]
    for row in rows:
        row["cell"] = TITLES[row["cell"]]
    return success_table(rows)._replace(title="Success and expected running time.")


def _audit() -> list[Block]:
    rows = [
        [
            str(row.table), TITLES[row.algo], row.column, _number(row.column, row.printed),
            f"{row.of_rows:.4f}" if row.column.startswith("l") else f"{row.of_rows:.1f}",
            f"{row.of_mended:.4f}" if row.column.startswith("l") else f"{row.of_mended:.1f}",
            "differs" if audit.differs(row) else "agrees",
        ]
        for row in audit.recomputed()
    ]  # fmt: skip
    note = "Averages as printed, of the rows as printed, and of the rows with their misprints mended."
    headings = ["table", "algorithm", "column", "printed", "of the rows", "of the mended rows", ""]
    return [
        Numbers("audit", Table("The paper's averages, recomputed.", note, headings, rows)),
        Heading("Rows that cannot be, or not as the text has it"),
        Bullets(list(audit.impossible_rows())),
        Heading("Where the text and the tables disagree"),
        Bullets(audit.contradictions()),
        Heading("Equations, as they must be meant and are computed here"),
        Bullets([f"{equation}. {correction}" for equation, correction in audit.EQUATIONS.items()]),
    ]


def _method(found: Findings) -> list[Block]:
    experiment = found.experiment
    rows = [
        [
            env,
            ENVIRONMENTS[env].title,
            "given" if env in experiment.given else "reconstruction",
            grid.moves,
            f"{grid.optimum:.4f}",
            grid.digest,
            str(len(experiment.further_maps(env))),
        ]
        for env, grid in experiment.maps.items()
    ]
    headings = ["map", "environment", "source", "diagonals", "exact optimum", "digest", "further maps"]
    note = "The exact optimum is by Dijkstra's algorithm; further maps are those of the ensemble."
    fits = [f"{env}: {grid.metadata['fit']}" for env, grid in experiment.maps.items() if "fit" in grid.metadata]
    settings = experiment.settings("pdg", {}).scalars
    text = (
        f"alpha = {settings.alpha:g}, beta = {settings.beta:g}, rho = {settings.rho:g}, {settings.ants} ants, "
        f"{settings.iterations} cycles, Q = {settings.q:g}, tau0 = {settings.tau0:g}. Further maps and other "
        f"readings: {experiment.ensemble_trials} trials each. Tests are scipy's; intervals are at 95 %; "
        "resampling has a fixed seed, so the same command writes the same tables."
    )
    blocks: list[Block] = [Text(text), Numbers("maps", Table("Maps.", note, headings, rows))]
    return [*blocks, Bullets(fits)] if fits else blocks


def _number(column: str, value: float) -> str:
    if value != value:
        return "-"
    return f"{value:.4f}" if column in ("l1", "l2", "l_bar") else f"{value:.1f}"


def _interval(column: str, estimate: Estimate) -> str:
    value, low, high = (_number(column, number) for number in estimate)
    return f"{value} [{low}, {high}]"


def _yes(flag: bool | None) -> str:
    return "-" if flag is None else "yes" if flag else "no"


def _p(p: float) -> str:
    return "< 0.001" if p < 0.001 else f"{p:.3f}"
