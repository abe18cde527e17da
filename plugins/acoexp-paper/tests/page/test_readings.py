"""The section on other readings of the paper."""

from __future__ import annotations

from acoexp_paper.claims.findings import Findings
from acoexp_paper.page.document import Text
from acoexp_paper.page.readings import readings


def test_each_reading_stands_with_the_averages_that_it_meets(found: Findings) -> None:
    fit = readings(found)[2].table
    assert fit.headings[:2] + fit.headings[-2:] == ["reading", "Table 1 Standard ACO", "Table 3 PDG", "all"]
    for row, outcome in zip(fit.rows, found.readings, strict=True):
        assert row[0] == outcome.reading.text
        assert row[1] == "{}/{}".format(*outcome.fit[1, "fig13", "aco"])
        assert row[-1] == f"{outcome.inside}/36"


def test_each_claim_stands_with_what_every_reading_says_of_it(found: Findings) -> None:
    key = next(key for key, says in found.readings[0].says.items() if says == 1)
    opposite = found.readings[1]._replace(says={**found.readings[1].says, key: -1})
    table = readings(found._replace(readings=[found.readings[0], opposite]))[3].table
    (row,) = (row for row in table.rows if f"{row[1]}: {row[0]}" == key)
    assert row[2:] == ["+", "-", "1 of 2"]
    assert "1: the defaults; 2: field.obstacles=nearest." in table.note


def test_the_readings_of_x2_are_counted_from_the_averages(found: Findings) -> None:
    met = [
        sum(row.inside for row in found.averages if row.printed.column == column) for column in ("x2", "x2_last")
    ]
    text = readings(found)[1]
    assert f"which meets {met[0]} of 6 published averages" in text.text
    assert f"it meets {met[1]}. Nothing" in text.text


def test_it_says_that_readings_were_left_out(found: Findings) -> None:
    assert readings(found._replace(readings=[])) == [Text("Left out, as report.ensemble_trials=0 asks for.")]
