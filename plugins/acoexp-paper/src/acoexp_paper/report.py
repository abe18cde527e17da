"""``report=paper``: what Liu et al. 2017 published, run again, and a verdict on every claim."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from acoexp.errors import MapError, SettingsError
from acoexp.grid.grid import Grid
from acoexp.maps.file import MapFile
from acoexp.parameters import parameter
from acoexp.registry.load_map import load_map
from acoexp.report.context import Context
from acoexp.report.progress import shown_progress
from acoexp.report.render import as_json, markdown_table, markdown_text
from acoexp.report.report import Report
from acoexp_paper.claims.catalogue import CLAIMS
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.words import VERDICTS
from acoexp_paper.page.contents import document
from acoexp_paper.page.document import tables_in
from acoexp_paper.page.latex import as_document, as_latex
from acoexp_paper.page.records import count_verdicts, records
from acoexp_paper.page.render import as_csv, as_html, as_markdown
from acoexp_paper.published.tables import ENVIRONMENTS
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.readings import trials_of_readings


@dataclass(frozen=True, kw_only=True)
class Paper(Report):
    """Tables, figures and claims of Liu et al. 2017, reproduced and judged."""

    trials: int = parameter(
        1000, "trials per algorithm and map, with the same seeds for all", minimum=10, maximum=100_000
    )
    ensemble_trials: int = parameter(
        200, "trials per algorithm on each further map; 0 leaves these out", minimum=0, maximum=100_000
    )
    reading_trials: int = parameter(
        15, "trials per algorithm and map under each other reading of the paper; 0 leaves these out",
        minimum=0, maximum=100_000,
    )  # fmt: skip
    maps: tuple[str, ...] = parameter(
        (), "the true maps, if you have them: 'fig13=path', 'env1=path', 'env2=path'"
    )

    def check(self, context: Context) -> None:
        """Refuse maps that cannot be read or are not the paper's, and settings that would not be used.

        Raises:
            SettingsError: for a part or a map of the command line's, and for maps that are not given as expected.
            MapError: for a map that cannot be read, or has not the published optimum.
        """
        if context.own_parts:
            raise SettingsError(
                f"{', '.join(context.own_parts)}: expected none with report=paper, which sets the parts"
            )
        if context.settings.scalars.patience is not None:
            raise SettingsError(
                f"patience: expected none with report=paper, whose trials run all of their cycles; got "
                f"{context.settings.scalars.patience}"
            )
        if context.grid.digest != load_map("fig13").digest:
            raise SettingsError(
                "map: expected none with report=paper; your own go into report.maps=['fig13=path']"
            )
        self.true_maps()

    def write(self, context: Context) -> Path:
        """Run what is missing and write the report.

        Raises:
            StrategyError: if a trial failed.
        """
        began = time.monotonic()
        given = self.true_maps()
        maps = {env: given.get(env) or load_map(env) for env in ENVIRONMENTS}
        readings = min(self.reading_trials, self.trials, self.ensemble_trials or self.trials)  # the same seeds
        experiment = Experiment(context, maps, frozenset(given), self.trials, self.ensemble_trials, readings)
        with shown_progress(experiment.size + trials_of_readings(experiment)) as show:
            found = Findings.of(replace(experiment, context=replace(context, show=show)), CLAIMS)
        with context.draft() as folder:
            _write_files(found, folder)
            took = {"seconds": round(time.monotonic() - began, 1), "processors": os.cpu_count()}
            (folder / "time.json").write_text(as_json(took), encoding="utf-8")
        return context.folder

    def headline(self, folder: Path) -> Sequence[Sequence[str]]:
        """Return how many claims of each environment that its maps were not fitted to have each verdict."""
        written = json.loads((folder / "tables.json").read_text(encoding="utf-8"))
        counts = [[env, *(str(count_verdicts(written, env, v)) for v in VERDICTS)] for env in ENVIRONMENTS]
        return [["claims", *VERDICTS], *counts]

    def true_maps(self) -> dict[str, Grid]:
        """Return the maps that the user gave, by environment.

        Raises:
            SettingsError: for one that is not ``<environment>=<path>``, or an environment given twice.
            MapError: for a map that cannot be read, or has not the published optimum.
        """
        given: dict[str, Grid] = {}
        for text in self.maps:
            env, equals, path = text.partition("=")
            if env not in ENVIRONMENTS or not equals or env in given:
                names = ", ".join(f"{name}=path" for name in ENVIRONMENTS)
                raise SettingsError(f"report.maps: expected some of: {names}, each once; got {text!r}")
            given[env] = _load(env, path)
        return given


def _load(env: str, path: str) -> Grid:
    try:
        grid = MapFile(path=path).load()
    except MapError as problem:
        raise MapError(f"report.maps: {env}: {problem}") from problem
    if grid.optimum_pair != ENVIRONMENTS[env].optimum_pair:
        raise MapError(
            f"report.maps: {env}: expected a map with the published optimum, {ENVIRONMENTS[env].optimum:.4f}; got "
            f"one with {grid.optimum:.4f} under the rule {grid.moves!r}"
        )
    return grid


def _write_files(found: Findings, folder: Path) -> None:
    from acoexp_paper.figures.everything import save_figures  # matplotlib takes its time to import

    for name in ("figures", "tables"):
        (folder / name).mkdir()
    drawings, captions = save_figures(found.experiment, folder / "figures")
    report = document(found, captions)
    texts = {
        "index.html": as_html(report, drawings),
        "report.md": as_markdown(report),
        "tables.json": as_json(records(found)),
    }
    for name, table in tables_in(report).items():
        head = f"**{markdown_text(table.title)}** {markdown_text(table.note)}"
        texts[f"tables/{name}.md"] = f"{head}\n\n{markdown_table(table)}\n"
        texts[f"tables/{name}.tex"] = as_latex(table)
        texts[f"tables/{name}.csv"] = as_csv(table)
    texts["tables/all.tex"] = as_document(tables_in(report))
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
