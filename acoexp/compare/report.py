"""``report=compare``: any two or more configurations, on any maps, side by side, and one verdict over the maps."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from acoexp.compare.configuration import Configuration, parse_configurations
from acoexp.compare.contents import MANY_MAPS, Compared, write_report
from acoexp.compare.export.ioh import export_trials
from acoexp.compare.learning import learning_row, optimises, without_learning
from acoexp.compare.maps import MapFacts, load_distinct, parse_maps
from acoexp.compare.measures import measured
from acoexp.compare.sample import Row, Sample
from acoexp.errors import SettingsError
from acoexp.grid.grid import Grid
from acoexp.parameters import parameter
from acoexp.report.context import Context
from acoexp.report.report import Report
from acoexp.report.table import number
from acoexp.trial.seeds import Seeds, parse_seeds

MOST_CYCLES = 10**8
"""Cycles of all trials together that one report may have; each takes 16 bytes of memory."""


@dataclass(frozen=True, kw_only=True)
class Compare(Report):
    """Configurations side by side: features, success, effect sizes, tests, curves; one verdict over maps."""

    cells: tuple[str, ...] = parameter(
        ("aco", "pd", "pdg", "pf"),
        "what is compared, each a preset and overrides, with a name if you like: 'more: pdg diffusion.gamma=0.02'",
    )
    maps: tuple[str, ...] = parameter(
        (),
        "maps, each a source, its file and keys, and numbers: fig13, 'rooms map.side=5#0-19', "
        "'movingai:a.map.scen#0-49'; by default that of the command line",
    )
    trials: int = parameter(
        100, "trials per configuration and map, with the same seeds for all", minimum=2, maximum=100_000
    )
    export: str = parameter(
        "none", "trials in another program's format too: ioh, for IOHanalyzer", choices=("none", "ioh")
    )

    def check(self, context: Context) -> None:
        """Refuse configurations and maps that are not known, and parts that no configuration would use."""
        compared = self._configurations(context)
        maps = sum(1 for _ in self._grids(context))
        cycles = (
            maps * self.trials * sum((1 + optimises(one)) * one.settings.scalars.iterations for one in compared)
        )
        if cycles > MOST_CYCLES:
            raise SettingsError(
                f"report.trials: expected at most {MOST_CYCLES} cycles of all trials together; got {cycles}: "
                f"{len(compared)} configurations on {maps} maps, {self.trials} trials each"
            )

    def write(self, context: Context) -> Path:
        """Run all configurations on all maps and write the report."""
        compared, seeds = self._configurations(context), parse_seeds(f"0-{self.trials - 1}")
        maps: list[MapFacts] = []
        samples: list[list[Sample]] = []
        learning: list[Row] = []
        for grid in self._grids(context):
            maps.append(MapFacts.of(grid))
            samples.append([self._sample(context, one, grid, seeds) for one in compared])
            for one, sample in zip(compared, samples[-1], strict=True):
                if optimises(one):
                    blind = self._sample(context, without_learning(one), grid, seeds)
                    learning.append(learning_row(sample, blind))
        with context.draft() as folder:
            write_report(folder, Compared(compared, maps, samples, self.trials, learning))
            if self.export == "ioh":
                export_trials(folder / "ioh", compared, maps, samples)
        return context.folder

    def headline(self, folder: Path) -> Sequence[Sequence[str]]:
        """Return how often and how soon each configuration found the optimum, and where it converged.

        Of many maps it is how the configurations rank over them.
        """
        with (folder / "ranks.csv").open(encoding="utf-8", newline="") as file:
            ranks = list(csv.DictReader(file))
        if int(ranks[0]["maps"]) > MANY_MAPS:
            return [["cell", "mean rank", "best on"], *map(_rank, ranks)]
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

    def _grids(self, context: Context) -> Iterator[Grid]:
        """Yield the maps one by one: of a thousand, no more than one is in memory."""
        yield from load_distinct(parse_maps(self.maps)) if self.maps else [context.grid]

    def _sample(self, context: Context, one: Configuration, grid: Grid, seeds: Seeds) -> Sample:
        return measured(one.label, grid, context.run(one.settings, grid, seeds, f"{one.label} on {grid.name}"))


def _short(row: dict[str, str]) -> list[str]:
    l2 = f"{float(row['l2']):.4f}" if row["l2"] else "-"
    return [row["map"], row["cell"], f"{row['found']}/{row['trials']}", number(float(row["ert"])), l2]


def _rank(row: dict[str, str]) -> list[str]:
    return [row["cell"], f"{float(row['mean_rank']):.2f}", f"{row['best_on']}/{row['maps']}"]
