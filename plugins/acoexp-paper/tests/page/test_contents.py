"""The whole report, and what stands in which section."""

from __future__ import annotations

from dataclasses import replace

from acoexp_paper.claims.findings import Findings
from acoexp_paper.page.contents import document
from acoexp_paper.page.document import Figure, tables_in
from small import ENSEMBLE_TRIALS, TABLES, TRIALS


def test_the_summary_comes_first_and_the_tables_in_their_order(found: Findings) -> None:
    report = document(found, {})
    assert [section.title for section in report.sections[:2]] == ["Summary", "The claims"]
    assert list(tables_in(report)) == TABLES


def test_figures_of_the_paper_stand_together_and_ours_with_the_maps(found: Findings) -> None:
    captions = {"fig01": ("Fig. 1. Force", "arrows"), "maps_env2": ("The maps", "all of them")}
    sections = {section.title: section.blocks for section in document(found, captions).sections}
    assert sections["Figures"][1:] == [Figure("fig01", "Fig. 1. Force", "arrows")]
    assert sections["Maps and method"][-1] == Figure("maps_env2", "Fig. A. The maps", "all of them")


def test_success_is_that_of_each_algorithm_on_each_environments_map(found: Findings) -> None:
    rows = tables_in(document(found, {}))["success"].rows
    hits = int(found.experiment.main["env1"]["pf"].found.sum())
    assert ["env1", "ACO-PF", f"{hits}/{TRIALS}"] in [row[:3] for row in rows]
    assert len(rows) == 3 + 2 + 4
    published = {tuple(row[:2]): row[-1] for row in rows}
    assert published["env2", "Standard ACO"] == "5/10"
    assert published["env1", "ACO-PF"] == "10/10"


def test_the_lead_says_what_was_run_and_what_is_not_as_in_the_paper(found: Findings) -> None:
    lead = document(found, {}).lead
    assert (
        f"{TRIALS} trials of each algorithm on each environment's map and {ENSEMBLE_TRIALS} on each further"
        in lead
    )
    assert lead.endswith("Other than in the paper: ants=5, iterations=12.")
    as_published = replace(found.experiment.context, settings=found.experiment.context.preset)
    plain = found._replace(experiment=replace(found.experiment, context=as_published))
    assert document(plain, {}).lead.endswith("env1 environment 1 of Table 3.")
