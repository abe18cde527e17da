"""What the report consists of: its page, its tables for other programs, its pictures."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path
from typing import NamedTuple

from acoexp.compare.configuration import Configuration
from acoexp.compare.maps import MapFacts
from acoexp.compare.measures import configuration_row, pair_rows
from acoexp.compare.over_maps.budgets import TARGETS, UNITS, Anytime, anytime
from acoexp.compare.over_maps.gallery import draw_over_maps
from acoexp.compare.over_maps.pooling import effect_row
from acoexp.compare.over_maps.tables import verdict_tables
from acoexp.compare.over_maps.values import MapValues, values_of_maps
from acoexp.compare.over_maps.verdict import ENOUGH, Verdict, verdict_over
from acoexp.compare.page import Page, Picture, Section, as_html, as_markdown
from acoexp.compare.render import as_latex
from acoexp.compare.sample import Row, Sample
from acoexp.compare.tables import learning_table, tables_of
from acoexp.report.render import as_csv, as_json

MANY_MAPS = 12
"""Maps up to which a person reads tables and curves of each; of more they are folded, or in files alone."""

_TITLE = "Comparison of ant colonies"


class Compared(NamedTuple):
    """What was run.

    Attributes:
        configurations: The configurations.
        maps: The maps.
        samples: The trials on each map, in the order of the configurations.
        trials: How many each.
        learning: A row for each configuration that optimises paths on each map: what its colony learns.
    """

    configurations: Sequence[Configuration]
    maps: Sequence[MapFacts]
    samples: Sequence[Sequence[Sample]]
    trials: int
    learning: Sequence[Row]


class Contents(NamedTuple):
    """What is said of it.

    Attributes:
        features: A row for each configuration on each map.
        pairs: A row for each measure of each two configurations on each map.
        values: What each configuration is worth on each map.
        verdict: What is said over the maps.
        effects: A row for each map of each configuration beside the first.
        reached: What each configuration reaches within budgets, by their unit.
    """

    features: list[Row]
    pairs: list[Row]
    values: MapValues
    verdict: Verdict
    effects: list[Row]
    reached: list[list[Anytime]]

    @classmethod
    def of(cls, samples: Sequence[Sequence[Sample]]) -> Contents:
        """Return what the samples of each map say."""
        flat = [sample for of_map in samples for sample in of_map]
        values = values_of_maps(samples)
        return cls(
            features=[configuration_row(sample) for sample in flat],
            pairs=pair_rows(flat),
            values=values,
            verdict=verdict_over(samples, values),
            effects=[effect_row(of_map[n], of_map[0]) for n in range(1, len(samples[0])) for of_map in samples],
            reached=[anytime(samples, unit, inference=len(samples) >= ENOUGH) for unit in UNITS],
        )

    def rows(self) -> dict[str, list[Row]]:
        """Return all rows by the name of the file that has them in full precision."""
        return {
            "cells": self.features,
            "pairs": self.pairs,
            "values": self.values.rows(),
            "ranks": self.verdict.ranks,
            "verdicts": self.verdict.pairs,
            "effects": self.effects,
            "budgets": [row for of_unit in self.reached for one in of_unit for row in one.rows()],
        }


def write_report(folder: Path, compared: Compared) -> None:
    """Write all files of a report into an empty folder."""
    contents = Contents.of(compared.samples)
    over_maps = draw_over_maps(folder, contents.values, contents.verdict, contents.effects, contents.reached)
    on_each = _on_each_map(folder, compared, contents)
    page = Page(_TITLE, _lead(compared), contents.verdict.text, [_over_maps(contents, over_maps), on_each])
    svgs = {one.name: (folder / f"{one.name}.svg").read_text(encoding="utf-8") for one in page.pictures}
    rows = contents.rows() | {"learning": [*compared.learning]}
    texts = {
        "index.html": as_html(page, svgs),
        "report.md": as_markdown(page),
        "tables.tex": as_latex(page.tables),
        "report.json": as_json({**_origin(compared), "verdict": _verdict(contents.verdict), **rows}),
        **{f"{name}.csv": as_csv(of_file) for name, of_file in rows.items() if of_file},
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")


def _over_maps(contents: Contents, pictures: Sequence[Picture]) -> Section:
    """Return what is inferred, from maps, and no test of seeds among it."""
    ranks, *pairs = verdict_tables(contents.verdict)
    diagram = [one for one in pictures if one.name == "ranks"]
    return Section("Over maps", [ranks, *diagram, *pairs, *(one for one in pictures if one not in diagram)])


def _on_each_map(folder: Path, compared: Compared, contents: Contents) -> Section:
    """Return what trials show on each map; of many maps it is folded, and without curves."""
    *of_cells, of_pairs = tables_of(contents.features, contents.pairs)
    tables = [*of_cells, of_pairs]
    files = [*("cells.csv" for _ in of_cells), "pairs.csv"]
    if compared.learning:
        tables, files = [*tables, learning_table(compared.learning)], [*files, "learning.csv"]
    if len(compared.maps) > MANY_MAPS:
        return Section("On each map", tables, {t.title: file for t, file in zip(tables, files, strict=True)})
    from acoexp.compare.curves import draw_curves  # matplotlib takes its time to import

    draw_curves([sample for of_map in compared.samples for sample in of_map], folder)
    note = "Median and quartiles of the best length in each cycle."
    return Section("On each map", [*tables, Picture("Convergence", note, "curves")])


def _lead(compared: Compared) -> str:
    configurations, maps = compared.configurations, compared.maps
    named = "".join(f" {one.label} is {one.text}." for one in configurations if one.label != one.text)
    on = f"{len(maps)} maps" if len(maps) > MANY_MAPS else ", ".join(facts.name for facts in maps)
    return (
        f"{len(configurations)} configurations on {on}: {compared.trials} trials each, "
        f"seeds 0 to {compared.trials - 1} for all. acoexp {version('acoexp')}.{named}{_warning(configurations)}"
    )


def _warning(compared: Sequence[Configuration]) -> str:
    """Say it where configurations may spend different numbers of walks, which no table shows."""
    text = ""
    for key in ("ants", "iterations", "patience"):
        values = {one.label: getattr(one.settings.scalars, key) for one in compared}
        if len(set(values.values())) > 1:
            each = ", ".join(f"{label}: {value}" for label, value in values.items())
            text += f" Warning: the configurations differ in {key} ({each}), so their efforts differ too."
    return text


def _origin(compared: Compared) -> Row:
    """Return what the numbers depend on."""
    return {
        "version": version("acoexp"),
        "trials": compared.trials,
        "maps": {facts.name: {"digest": facts.digest, "optimum": facts.optimum} for facts in compared.maps},
        "packages": {one.label: one.settings.packages for one in compared.configurations},
        "configurations": {one.label: one.settings.as_dict() for one in compared.configurations},
        "targets": TARGETS,
    }


def _verdict(verdict: Verdict) -> Row:
    test = verdict.friedman
    return {
        "text": verdict.text,
        "friedman": None if test is None else test._asdict(),
        "critical_difference": verdict.difference,
    }
