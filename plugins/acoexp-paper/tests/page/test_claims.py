"""The table of claims."""

from __future__ import annotations

from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.kinds import Claim, Finding
from acoexp_paper.claims.statements import Every
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.page.claims import claims

from acoexp.compare.statistics import Estimate

CLAIM = Claim("Sect. 5", "env2", Every("found", "aco"), fitted=True)
FINDING = Finding("a test", 0.0004, "share", Estimate(0.5, 0.4, 0.6))


def row(judged: Judged) -> list[str]:
    _, table = claims([judged])
    return table.table.rows[0]


def test_a_claim_stands_with_its_test_its_effect_and_what_the_maps_say() -> None:
    over_maps = Finding("over maps", 0.03, "mean share", Estimate(0.7, 0.6, 0.8))
    judged = Judged(CLAIM, FINDING, 0.0008, "holds", over_maps, (1, 1, 0, -1), "depends on the map")
    assert row(judged) == [
        "Standard ACO finds the optimum in every trial *",
        "Sect. 5",
        "env2",
        "a test",
        "< 0.001",
        "share 0.50 [0.40, 0.60]",
        "holds",
        "2 / 1 / 1",
        "0.70 [0.60, 0.80], p 0.030",
        "depends on the map",
    ]


def test_what_is_not_known_is_a_dash() -> None:
    assert row(Judged(CLAIM, FINDING, 0.5, None, None, (), "holds"))[4:] == [
        "0.500",
        "share 0.50 [0.40, 0.60]",
        "-",
        "-",
        "-",
        "holds",
    ]


def test_every_claim_has_its_row(found: Findings) -> None:
    _, table = claims(found.claims)
    assert [line[-1] for line in table.table.rows] == [judged.verdict for judged in found.claims]
