"""The section on other readings of the paper."""

from __future__ import annotations

from acoexp_paper.claims.catalogue import CLAIMS
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.rereading import Outcome, outcome
from acoexp_paper.page.document import Document, Section, Text, tables_in
from acoexp_paper.page.readings import readings
from acoexp_paper.trials.readings import ENVS, SUM_IN

from acoexp.report.table import Table


def from_sum_in(found: Findings) -> Outcome:
    """Return what another source leads to, as if its trials were the defaults'."""
    samples = {env: found.experiment.samples[env] for env in ENVS}
    return outcome(SUM_IN, CLAIMS, {env: [*of_env] for env, of_env in samples.items()}, samples)


def tables(found: Findings) -> dict[str, Table]:
    return tables_in(Document("", "", [Section("", readings(found))]))


def test_another_source_leads_with_every_claim_about_aco_pd(found: Findings) -> None:
    source = from_sum_in(found)
    key = next(key for key, one in source.claims.items() if "pd" in one.judged.claim.kind.algos)
    table = tables(found._replace(readings=[source._replace(changed=(key,)), *found.readings]))["sources"]
    assert table.headings == ["claim", "map", "paper", "force_edge (default)", "sum_in"]
    assert all("ACO-PD" in row[0] for row in table.rows)
    changed, *others = table.rows
    assert changed[4] == f"{changed[3]} *"
    assert [row[3] for row in others] == [row[4] for row in others]


def test_each_reading_stands_with_the_averages_that_it_meets(found: Findings) -> None:
    fit = tables(found)["readings"]
    assert fit.headings[:3] + fit.headings[-3:] == [
        "reading", "maps", "Table 1 Standard ACO", "Table 3 PDG", "all", "changed",
    ]  # fmt: skip
    defaults, nearest = fit.rows
    assert (defaults[:2], nearest[:2]) == (["the defaults", "3 + 3"], ["field.obstacles=nearest", "3 + 3"])
    (reading,) = found.readings
    assert nearest[2] == "{}/{}".format(*reading.fit[1, "fig13", "aco"])
    assert nearest[-2:] == [f"{reading.inside}/33", str(len(reading.changed))]


def test_a_reading_that_fits_no_map_of_an_environment_has_dashes(found: Findings) -> None:
    (reading,) = found.readings
    on_fig13 = {block: met for block, met in reading.fit.items() if block[1] == "fig13"}
    some = reading._replace(maps={"fig13": 3, "env2": 0}, fit=on_fig13)
    row = tables(found._replace(readings=[some]))["readings"].rows[1]
    assert row[1] == "3 + 0"
    assert row[5:9] == ["-"] * 4


def test_each_claim_stands_with_what_every_reading_says_of_it(found: Findings) -> None:
    (reading,) = found.readings
    key, again = next(iter(reading.claims.items()))
    shown = again._replace(judged=again.judged._replace(verdict="shown"))
    changed = reading._replace(claims={key: shown}, changed=(key,))
    table = tables(found._replace(readings=[changed]))["reading_claims"]
    (row,) = table.rows
    assert f"{row[1]}: {row[0][0].upper()}{row[0][1:]}" in key
    assert row[3] == "+*"
    assert "0: the defaults; 1: field.obstacles=nearest." in table.note


def test_the_readings_of_x2_are_counted_from_the_averages(found: Findings) -> None:
    met = [
        sum(row.inside for row in found.averages if row.printed.column == column) for column in ("x2", "x2_last")
    ]
    text = " ".join(block.text for block in readings(found) if isinstance(block, Text))
    assert f"which meets {met[0]} of 6 published averages" in text
    assert f"it meets {met[1]}: the column" in text


def test_it_says_that_readings_were_left_out(found: Findings) -> None:
    assert readings(found._replace(readings=[])) == [Text("Left out, as report.reading_trials=0 asks for.")]
