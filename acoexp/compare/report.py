"""``report=compare``: any two or more configurations, on any maps, side by side."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

from acoexp.compare.configuration import Configuration, parse_configurations
from acoexp.compare.measures import Row, Sample, configuration_row, pair_rows
from acoexp.compare.render import as_html, as_latex, as_markdown
from acoexp.compare.tables import tables_of
from acoexp.errors import AcoexpError, SettingsError, shown
from acoexp.grid.grid import Grid
from acoexp.parameters import parameter
from acoexp.registry.parts import build_part
from acoexp.report.context import Context
from acoexp.report.render import as_csv, as_json
from acoexp.report.report import Report
from acoexp.report.table import number
from acoexp.trial.seeds import parse_seeds

_TITLE = "Comparison of ant colonies"


@dataclass(frozen=True, kw_only=True)
class Compare(Report):
    """Configurations side by side: features, success, effect sizes, corrected tests, curves."""

    cells: tuple[str, ...] = parameter(
        ("aco", "pd", "pdg", "pf"),
        "what is compared, each a preset and overrides, with a name if you like: 'more: pdg diffusion.gamma=0.02'",
    )
    maps: tuple[str, ...] = parameter((), "names of maps, by default that of the command line")
    trials: int = parameter(
        100, "trials per configuration and map, with the same seeds for all", minimum=2, maximum=100_000
    )

    def check(self, context: Context) -> None:
        """Refuse configurations and maps that are not known, and parts that no configuration would use."""
        self._configurations(context)
        self._grids(context)

    def write(self, context: Context) -> Path:
        """Run all configurations on all maps and write the report."""
        compared, grids = self._configurations(context), self._grids(context)
        seeds = parse_seeds(f"0-{self.trials - 1}")
        samples = [
            Sample.of(one.label, grid, context.run(one.settings, grid, seeds, f"{one.label} on {grid.name}"))
            for grid in grids
            for one in compared
        ]
        with context.draft() as folder:
            self._write_files(folder, compared, grids, samples)
        return context.folder

    def headline(self, folder: Path) -> Sequence[Sequence[str]]:
        """Return how often and how soon each configuration found the optimum, and where it converged."""
        with (folder / "cells.csv").open(encoding="utf-8", newline="") as file:
            rows = [_short(row) for row in csv.DictReader(file)]
        return [["map", "cell", "found", "expected cycles", "l2"], *rows]

    def _configurations(self, context: Context) -> list[Configuration]:
        if context.own_parts:
            raise SettingsError(
                f"{', '.join(context.own_parts)}: expected within report.cells, such as "
                f"'pdg diffusion.gamma=0.02'; with report=compare the command line's own parts are not used"
            )
        return parse_configurations(self.cells, context.own_settings)

    def _grids(self, context: Context) -> list[Grid]:
        return [_load(name) for name in dict.fromkeys(self.maps)] or [context.grid]

    def _write_files(
        self, folder: Path, compared: Sequence[Configuration], grids: Sequence[Grid], samples: Sequence[Sample]
    ) -> None:
        from acoexp.compare.curves import draw_curves  # matplotlib takes its time to import

        features, pairs = [configuration_row(sample) for sample in samples], pair_rows(samples)
        tables, lead = tables_of(features, pairs), self._lead(compared, grids)
        draw_curves(samples, folder)
        svg = (folder / "curves.svg").read_text(encoding="utf-8")
        texts = {
            "index.html": as_html(_TITLE, lead, tables, svg),
            "report.md": as_markdown(_TITLE, lead, tables, "curves.svg"),
            "tables.tex": as_latex(tables),
            "cells.csv": as_csv(features),
            "pairs.csv": as_csv(pairs),
            "report.json": as_json({**self._origin(compared, grids), "cells": features, "pairs": pairs}),
        }
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8")

    def _lead(self, compared: Sequence[Configuration], grids: Sequence[Grid]) -> str:
        named = "".join(f" {one.label} is {one.text}." for one in compared if one.label != one.text)
        maps = ", ".join(grid.name for grid in grids)
        return (
            f"{len(compared)} configurations on {maps}: {self.trials} trials each, "
            f"seeds 0 to {self.trials - 1} for all. acoexp {version('acoexp')}.{named}{_warning(compared)}"
        )

    def _origin(self, compared: Sequence[Configuration], grids: Sequence[Grid]) -> Row:
        """Return what the numbers depend on."""
        return {
            "version": version("acoexp"),
            "trials": self.trials,
            "maps": {grid.name: {"digest": grid.digest, "optimum": grid.optimum} for grid in grids},
            "packages": {one.label: one.settings.packages for one in compared},
            "configurations": {one.label: one.settings.as_dict() for one in compared},
        }


def _warning(compared: Sequence[Configuration]) -> str:
    """Say it where configurations may spend different numbers of walks, which no table shows."""
    text = ""
    for key in ("ants", "iterations", "patience"):
        values = {one.label: getattr(one.settings.scalars, key) for one in compared}
        if len(set(values.values())) > 1:
            each = ", ".join(f"{label}: {value}" for label, value in values.items())
            text += f" Warning: the configurations differ in {key} ({each}), so their efforts differ too."
    return text


def _short(row: dict[str, str]) -> list[str]:
    l2 = f"{float(row['l2']):.4f}" if row["l2"] else "-"
    return [row["map"], row["cell"], f"{row['found']}/{row['trials']}", number(float(row["ert"])), l2]


def _load(name: str) -> Grid:
    try:
        grid: Grid = build_part("map", name, {}).load()
    except AcoexpError as problem:
        raise type(problem)(f"report.maps: {shown(name)}: {problem}") from problem
    return grid
