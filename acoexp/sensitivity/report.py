"""``report=sensitivity``: which of a configuration's numbers matter on a map, and how much."""

from __future__ import annotations

import csv
import logging
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from acoexp.errors import SettingsError
from acoexp.parameters import parameter
from acoexp.report.context import Context
from acoexp.report.render import as_csv, as_json
from acoexp.report.report import Report
from acoexp.sensitivity.factors import parse_factors
from acoexp.sensitivity.page import as_html, as_markdown, headline_rows, parts_of
from acoexp.sensitivity.rows import curve_rows, point_rows, share_rows
from acoexp.sensitivity.study import Findings, Study
from acoexp.sensitivity.verdict import verdict

log = logging.getLogger(__name__)

MOST_TRIALS = 1_000_000
"""Trials that one report may run."""

_TITLE = "Which keys matter"


@dataclass(frozen=True, kw_only=True)
class Sensitivity(Report):
    """Which numbers of a configuration matter on a map: curves, and shares of the variance."""

    keys: tuple[str, ...] = parameter(
        (),
        "what is varied, each a key or a key with its span, such as 'rho=interval(0.1,0.9)'; by default alpha, "
        "beta, rho and the numbers of the parts",
    )
    points: int = parameter(
        64, "points of each sample of the design, a power of two; it has a sample for each key, and two",
        minimum=8, maximum=8192,
    )  # fmt: skip
    replicates: int = parameter(4, "trials at each of them, each with a seed of its own", minimum=2, maximum=1000)
    trials: int = parameter(
        50, "trials of each value of a curve, with the same seeds for all", minimum=2, maximum=100_000
    )

    def check(self, context: Context) -> None:
        """Refuse keys that cannot be varied as is said, and a design that is none or too large."""
        if self.points & (self.points - 1):
            raise SettingsError(f"report.points: expected a power of two, such as 64; got {self.points}")
        study = self._study(context)
        if study.size > MOST_TRIALS:
            raise SettingsError(
                f"report: expected at most {MOST_TRIALS} trials; got {study.size} by report.points={self.points}, "
                f"report.replicates={self.replicates}, report.trials={self.trials} and {len(study.factors)} keys"
            )

    def write(self, context: Context) -> Path:
        """Run what is missing and write the report.

        Raises:
            SettingsError: for values that no configuration may have together.
            StrategyError: if a trial failed.
        """
        study = self._study(context)
        log.info("report=sensitivity: %d trials of %d configurations", study.size, study.configurations)
        found = study.run(context)
        with context.draft() as folder:
            _write_files(found, context, folder)
        return context.folder

    def headline(self, folder: Path) -> Sequence[Sequence[str]]:
        """Return the share of each outcome's variance that each key, or the seeds, make up."""
        with (folder / "shares.csv").open(encoding="utf-8", newline="") as file:
            return headline_rows(list(csv.DictReader(file)))

    def _study(self, context: Context) -> Study:
        factors = parse_factors(self.keys, context.algo, context.settings)
        return Study(factors, self.points, self.replicates, self.trials)


def _write_files(found: Findings, context: Context, folder: Path) -> None:
    from acoexp.sensitivity.pictures import draw_curves, draw_shares  # matplotlib takes its time to import

    study = found.study
    keys = [factor.key for factor in study.factors]
    rows = {
        "shares": share_rows(keys, found.shares),
        "curves": curve_rows(study.levels, found.curves, found.worst_gap),
        "points": point_rows(study.design, found.design, study.points),
    }
    draw_shares(rows["shares"], keys, folder)
    draw_curves(rows["curves"], study.factors, folder)
    pictures = {name: (folder / name).read_text(encoding="utf-8") for name in ("shares.svg", "curves.svg")}
    title, lead = f"{_TITLE} on {context.grid.name}", _lead(found, context)
    parts = parts_of(study.factors, found.shares)
    texts = {
        "index.html": as_html(title, lead, parts, pictures),
        "report.md": as_markdown(title, lead, parts),
        "report.json": as_json({**_origin(study, context), "verdict": lead[0], **rows}),
        **{f"{name}.csv": as_csv(content) for name, content in rows.items()},
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")


def _origin(study: Study, context: Context) -> dict[str, Any]:
    """Return what the numbers depend on."""
    grid, settings = context.grid, context.settings
    return {
        "version": version("acoexp"),
        "map": {"name": grid.name, "digest": grid.digest, "optimum": grid.optimum},
        "settings": settings.as_dict(),
        "packages": settings.packages,
        "keys": {f.key: {"span": str(f.span), "low": f.span.low, "high": f.span.high} for f in study.factors},
    }


def _lead(found: Findings, context: Context) -> list[str]:
    """Return the page's first paragraphs: the verdict, what was run, and what it cannot tell."""
    study, grid = found.study, context.grid
    keys = [factor.key for factor in study.factors]
    ran = (
        f"{context.settings.label} on {grid.name}, optimum {grid.optimum:.4f}: {study.size} trials of "
        f"{study.configurations} configurations, {study.replicates} at each of {len(study.design)} points of a "
        f"Saltelli design and {study.trials} at each of {len(study.levels)} points of the curves. "
        f"acoexp {version('acoexp')}."
    )
    said = "What holds, holds for this map, within these spans, about this configuration."
    notes = []
    if found.never_arrived:
        notes = [
            f"In {found.never_arrived} of {study.size} trials no ant arrived; they have no length, and are taken "
            f"for trials with the largest gap of all, {found.worst_gap:.2f} %, which is too kind to them."
        ]
    efforts = " and ".join(key for key in keys if key in ("ants", "iterations"))
    if efforts:
        notes.append(f"Warning: {efforts} varied, and with it the effort: who walks more finds more.")
    return [verdict(keys, found.shares, grid.name), f"{ran} {said}", *notes]
