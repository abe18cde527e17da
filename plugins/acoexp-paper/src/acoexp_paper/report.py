"""``report=paper``: what Liu et al. 2017 published, run again, and a verdict on every claim."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from acoexp.errors import MapError, SettingsError
from acoexp.grid import Grid, path_length
from acoexp.maps.file import MapFile
from acoexp.parameters import parameter
from acoexp.report import render
from acoexp.report.context import Context
from acoexp.report.report import Report, written_whole
from acoexp.report.tables import Table
from acoexp_paper import readings
from acoexp_paper.document import as_html, as_markdown, tables_in
from acoexp_paper.experiment import Experiment, builtin_map
from acoexp_paper.progress import shown_progress
from acoexp_paper.published import ENVIRONMENTS
from acoexp_paper.sections import Findings, document
from acoexp_paper.verdicts import VERDICTS


@dataclass(frozen=True, kw_only=True)
class Paper(Report):
    """Tables, figures and claims of Liu et al. 2017, reproduced and judged."""

    trials: int = parameter(1000, "trials per cell, with the same seeds for all", minimum=10, maximum=100_000)
    ensemble_trials: int = parameter(
        100, "trials per cell on each further map and under each other reading; 0 leaves both out",
        minimum=0, maximum=100_000,
    )  # fmt: skip
    maps: tuple[str, ...] = parameter(
        (), "the true maps, if you have them: 'fig13=path', 'env1=path', 'env2=path'"
    )

    def check(self, context: Context) -> None:
        """Refuse maps that cannot be read or are not the paper's, and settings that would not be used."""
        if context.own_parts:
            raise SettingsError(
                f"{', '.join(context.own_parts)}: expected none with report=paper, which sets the parts"
            )
        if context.grid.digest != builtin_map("fig13").digest:
            raise SettingsError(
                "map: expected none with report=paper; your own go into report.maps=['fig13=path']"
            )
        self._maps()

    def write(self, context: Context) -> Path:
        """Run what is missing and write the report."""
        given = self._maps()
        maps = {env: given.get(env) or builtin_map(env) for env in ENVIRONMENTS}
        experiment = Experiment(context, maps, frozenset(given), self.trials, self.ensemble_trials)
        with shown_progress(experiment.size + readings.size(experiment)) as tell:
            found = Findings.of(replace(experiment, context=replace(context, tell=tell)))
        with written_whole(context.folder) as folder:
            _write_files(found, folder)
        return context.folder

    def headline(self, folder: Path) -> Sequence[Sequence[str]]:
        """Return how many claims of each environment hold, and how many do not."""
        claims = json.loads((folder / "tables.json").read_text(encoding="utf-8"))["claims"]
        rows = [[env, *(str(_count(claims, env, verdict)) for verdict in VERDICTS)] for env in ENVIRONMENTS]
        return [["claims", *VERDICTS], *rows]

    def _maps(self) -> dict[str, Grid]:
        given = {}
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
    published = ENVIRONMENTS[env].straight, ENVIRONMENTS[env].diagonal
    if grid.optimum_pair != published:
        raise MapError(
            f"report.maps: {env}: expected a map with the published optimum, {path_length(*published):.4f}; got "
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
        "tables.json": render.as_json(_content(found)),
    }
    for name, table in tables_in(report).items():
        texts[f"tables/{name}.md"] = f"**{table.title}** {table.note}\n\n{render.markdown_table(table)}\n"
        texts[f"tables/{name}.tex"] = render.as_latex([table])
        texts[f"tables/{name}.csv"] = _csv(table)
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")


def _content(found: Findings) -> dict[str, Any]:
    """Return the averages and the claims in full precision."""
    experiment = found.experiment
    return {
        "trials": experiment.trials,
        "ensemble_trials": experiment.ensemble_trials,
        "maps": {
            env: {
                "digest": grid.digest,
                "given": env in experiment.given,
                "ensemble": [further.digest for further in experiment.further_maps(env)],
            }
            for env, grid in experiment.maps.items()
        },
        "tables": [
            {
                "table": row.table,
                "map": row.map,
                "algorithm": row.algorithm,
                "column": row.column,
                "published": row.published,
                "first_ten": row.first_ten,
                "mean": row.ours.value,
                "interval": [row.ours.low, row.ours.high],
                "inside": row.inside,
                "ensemble_mean": None if row.ensemble is None else row.ensemble.value,
                "ensemble_interval": None if row.ensemble is None else [row.ensemble.low, row.ensemble.high],
                "ensemble_inside": row.ensemble_inside,
            }
            for row in found.averages
        ],
        "claims": [
            {
                "key": judged.claim.key,
                "claim": judged.claim.text,
                "where": judged.claim.where,
                "map": judged.claim.map,
                "fitted": judged.claim.fitted,
                "statistic": judged.finding.statistic,
                "p": judged.finding.p,
                "p_holm": judged.p_holm,
                "measure": judged.finding.measure,
                "effect": judged.finding.effect.value,
                "interval": [judged.finding.effect.low, judged.finding.effect.high],
                "on_map": judged.on_map,
                "maps": list(judged.says),
                "over_maps": None if judged.over_maps is None else _over(judged.over_maps),
                "verdict": judged.verdict,
            }
            for judged in found.claims
        ],
        "readings": [
            {
                "reading": outcome.reading.text,
                "fit": [
                    {"table": t, "map": env, "algorithm": a, "inside": i, "of": n}
                    for (t, env, a), (i, n) in outcome.fit.items()
                ],
                "claims": outcome.says,
            }
            for outcome in found.readings
        ],
    }


def _over(finding: Any) -> dict[str, Any]:
    return {
        "statistic": finding.statistic,
        "p": finding.p,
        "measure": finding.measure,
        "effect": finding.effect.value,
        "interval": [finding.effect.low, finding.effect.high],
    }


def _count(claims: Sequence[dict[str, Any]], env: str, verdict: str) -> int:
    return sum(claim["map"] == env and claim["verdict"] == verdict for claim in claims)


def _csv(table: Table) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([table.headings, *table.rows])
    return text.getvalue()
