"""``report=compare``: any two or more configurations, on any maps, side by side."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

from acoexp import registry
from acoexp.blame import packages_of
from acoexp.errors import AcoexpError, SettingsError
from acoexp.grid import Grid
from acoexp.parameters import parameter
from acoexp.report import render
from acoexp.report.cell import Cell, parse_cells
from acoexp.report.context import Context
from acoexp.report.measures import Row, Sample, cell_row, pair_rows
from acoexp.report.report import Report, written_whole
from acoexp.report.tables import number, tables_of
from acoexp.seeds import parse_seeds

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
        100, "trials per cell and map, with the same seeds for all", minimum=2, maximum=100_000
    )

    def check(self, context: Context) -> None:
        """Refuse cells and maps that are not known, and parts that no cell would use."""
        self._cells(context)
        self._grids(context)

    def write(self, context: Context) -> Path:
        """Run all cells on all maps and write the report."""
        cells, grids = self._cells(context), self._grids(context)
        seeds = parse_seeds(f"0-{self.trials - 1}")
        samples = [
            Sample.of(cell.label, grid, context.run(cell.settings, grid, seeds, f"{cell.label} on {grid.name}"))
            for grid in grids
            for cell in cells
        ]
        with written_whole(context.folder) as folder:
            self._write_files(folder, cells, grids, samples)
        return context.folder

    def headline(self, folder: Path) -> Sequence[Sequence[str]]:
        """Return how often and how soon each cell found the optimum, and where it converged."""
        with (folder / "cells.csv").open(encoding="utf-8", newline="") as file:
            rows = [_short(row) for row in csv.DictReader(file)]
        return [["map", "cell", "found", "expected cycles", "l2"], *rows]

    def _cells(self, context: Context) -> list[Cell]:
        if context.own_parts:
            raise SettingsError(
                f"{', '.join(context.own_parts)}: expected within report.cells, such as "
                f"'pdg diffusion.gamma=0.02'; with report=compare the command line's own parts are not used"
            )
        return parse_cells(self.cells, context.own_settings)

    def _grids(self, context: Context) -> list[Grid]:
        return [_load(name) for name in dict.fromkeys(self.maps)] or [context.grid]

    def _write_files(
        self, folder: Path, cells: Sequence[Cell], grids: Sequence[Grid], samples: Sequence[Sample]
    ) -> None:
        from acoexp.report.curves import draw_curves  # matplotlib takes its time to import

        features, pairs = [cell_row(sample) for sample in samples], pair_rows(samples)
        tables, lead = tables_of(features, pairs), self._lead(cells, grids)
        draw_curves(samples, folder)
        svg = (folder / "curves.svg").read_text(encoding="utf-8")
        texts = {
            "index.html": render.as_html(_TITLE, lead, tables, svg),
            "report.md": render.as_markdown(_TITLE, lead, tables, "curves.svg"),
            "tables.tex": render.as_latex(tables),
            "cells.csv": render.as_csv(features),
            "pairs.csv": render.as_csv(pairs),
            "report.json": render.as_json({**self._origin(cells, grids), "cells": features, "pairs": pairs}),
        }
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8")

    def _lead(self, cells: Sequence[Cell], grids: Sequence[Grid]) -> str:
        named = "".join(f" {cell.label} is {cell.text}." for cell in cells if cell.label != cell.text)
        return (
            f"{len(cells)} configurations on {', '.join(grid.name for grid in grids)}: {self.trials} trials each, "
            f"seeds 0 to {self.trials - 1} for all. acoexp {version('acoexp')}.{named}{_warning(cells)}"
        )

    def _origin(self, cells: Sequence[Cell], grids: Sequence[Grid]) -> Row:
        """Return what the numbers depend on."""
        return {
            "version": version("acoexp"),
            "trials": self.trials,
            "maps": {grid.name: {"digest": grid.digest, "optimum": grid.optimum} for grid in grids},
            "packages": {cell.label: packages_of(cell.settings) for cell in cells},
            "configurations": {cell.label: cell.settings.as_dict() for cell in cells},
        }


def _warning(cells: Sequence[Cell]) -> str:
    """Say it where cells may spend different numbers of walks, which no table shows."""
    text = ""
    for key in ("ants", "iterations"):
        values = {cell.label: getattr(cell.settings.scalars, key) for cell in cells}
        if len(set(values.values())) > 1:
            each = ", ".join(f"{label}: {value}" for label, value in values.items())
            text += f" Warning: the configurations differ in {key} ({each}), so their efforts differ too."
    return text


def _short(row: dict[str, str]) -> list[str]:
    l2 = f"{float(row['l2']):.4f}" if row["l2"] else "-"
    return [row["map"], row["cell"], f"{row['found']}/{row['trials']}", number(float(row["ert"])), l2]


def _load(name: str) -> Grid:
    try:
        grid: Grid = registry.build_part("map", name, {}).load()
    except AcoexpError as problem:
        raise type(problem)(f"report.maps: {name!r}: {problem}") from problem
    return grid
