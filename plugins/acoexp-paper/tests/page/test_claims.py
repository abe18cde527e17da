"""The tables of claims."""

from __future__ import annotations

import numpy as np
from acoexp_paper.claims.comparisons import Fewer
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.pooling import Effect, Over
from acoexp_paper.claims.statements import CountIs
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.claims.words import MEANING
from acoexp_paper.page.claims import claims
from acoexp_paper.page.document import Bullets, Document, Section, tables_in

from acoexp.compare.statistics import Estimate
from acoexp.report.table import Table

SOONER = Claim("Sect. 5", "env2", Fewer("hitting time", "pdg", "pd"))
FITTED = Claim("Sect. 5", "env2", CountIs("found", "aco", 5), fitted=True)
OVER = Over(Estimate(0.7, 0.6, 0.8), (0.45, 0.95), 0.12, 0.05, 23.0, 0.0004)


def judged(claim: Claim) -> Judged:
    effects = (Effect(0.75, 0.0001), Effect(0.65, 0.0001))
    return Judged(claim, 1.0, effects, OVER, None, 0.001, 0.02, "depends on the map", (True, False))


def tables(*claims_: Judged) -> dict[str, Table]:
    return tables_in(Document("", "", [Section("", claims(claims_))]))


def test_a_comparison_stands_with_the_papers_effect_ours_and_the_next_maps() -> None:
    assert tables(judged(SOONER))["comparisons"].rows == [
        [
            "ACO-PDG finds the optimum in fewer iterations than ACO-PD",
            "Sect. 5",
            "env2",
            "A12",
            "1.00",
            "0.75 [0.73, 0.77]",
            "0.70 [0.60, 0.80]",
            "[0.45, 0.95]",
            "0.020",
            "depends on the map",
        ]
    ]


def test_a_printed_number_that_the_maps_were_fitted_to_is_marked() -> None:
    assert tables(judged(FITTED))["printed"].rows[0][0] == "Standard ACO finds the optimum in 5 of ten trials *"


def test_the_spread_stands_with_the_weighted_effect() -> None:
    weighted = judged(SOONER)._replace(weighted=OVER._replace(maps=3.5))
    plain, with_weights = (tables(one)["spread"].rows[0] for one in (judged(SOONER), weighted))
    assert plain[1:] == ["env2", "23", "50%", "0.12", "< 0.001", "0.70 [0.60, 0.80]", "-", "-"]
    assert with_weights[-2:] == ["0.70 [0.60, 0.80]", "3.5"]
    few = judged(SOONER)._replace(weighted=OVER._replace(maps=1.5))
    assert tables(few)["spread"].rows[0][-2:] == ["0.70", "1.5"]


def test_what_is_not_known_is_a_dash() -> None:
    alone = judged(SOONER)._replace(published=None, over=OVER._replace(next=None, spread=np.nan))
    row = tables(alone)["comparisons"].rows[0]
    assert (row[4], row[7]) == ("-", "-")


def test_every_claim_has_its_row_and_every_verdict_its_meaning(found: Findings) -> None:
    made = tables(*found.claims)
    verdicts = [row[-1] for name in ("comparisons", "printed") for row in made[name].rows]
    assert sorted(verdicts) == sorted(judged.verdict for judged in found.claims)
    assert len(made["spread"].rows) == len(found.claims)
    (meanings,) = (block.items for block in claims(found.claims) if isinstance(block, Bullets))
    assert [item.partition(":")[0] for item in meanings] == list(MEANING)
