"""The whole report, and what stands in which section."""

from __future__ import annotations

from dataclasses import replace
from importlib.metadata import version

from acoexp_paper.claims.findings import Findings
from acoexp_paper.page.contents import document
from acoexp_paper.page.document import Figure, tables_in
from small import TABLES, TRIALS


def test_the_summary_comes_first_and_the_tables_in_their_order(found: Findings) -> None:
    report = document(found, {})
    assert [section.title for section in report.sections[:2]] == ["Summary", "Tables 1 to 3"]
    assert list(tables_in(report)) == TABLES


def test_figures_stand_with_their_captions(found: Findings) -> None:
    sections = {section.title: section.blocks for section in document(found, {"fig01": "a caption"}).sections}
    assert sections["Figures"] == [Figure("fig01", "a caption")]


def test_success_is_that_of_each_algorithm_on_each_environments_map(found: Findings) -> None:
    rows = tables_in(document(found, {}))["success"].rows
    hits = int(found.experiment.main["env1"]["pf"].found.sum())
    assert ["env1", "ACO-PF", f"{hits}/{TRIALS}"] in [row[:3] for row in rows]
    assert len(rows) == 3 + 2 + 4


def test_the_lead_says_what_was_run_and_what_is_not_as_in_the_paper(found: Findings) -> None:
    lead = document(found, {}).lead
    assert (
        f"acoexp {version('acoexp')}: {TRIALS} trials per algorithm and map, seeds 0 to {TRIALS - 1} for all"
        in lead
    )
    assert lead.endswith("Other than in the paper: ants=5, iterations=12.")
    as_published = replace(found.experiment.context, settings=found.experiment.context.preset)
    plain = found._replace(experiment=replace(found.experiment, context=as_published))
    assert document(plain, {}).lead.endswith("the ten that the paper averages over.")
