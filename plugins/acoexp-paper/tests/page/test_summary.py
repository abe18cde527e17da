"""The summary, in words."""

from __future__ import annotations

from dataclasses import replace

import pytest
from acoexp_paper.claims.comparisons import Fewer
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.kinds import Claim, Finding, Kind
from acoexp_paper.claims.statements import CountIs
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.page.document import Bullets, Heading
from acoexp_paper.page.summary import summary

from acoexp.compare.statistics import Estimate

LOST = Fewer("lost ants", "pd", "aco")


def judged(verdict: str, kind: Kind = LOST, env: str = "fig13", says: tuple[int, ...] = ()) -> Judged:
    finding = Finding("", 0.0, "A12", Estimate(0.9, 0.8, 1.0))
    return Judged(Claim("", env, kind), finding, 0.0, verdict, None, says, verdict)


def said(found: Findings, claims: list[Judged]) -> list[str]:
    """Return all that the summary says of claims, line by line."""
    lines = []
    for block in summary(found._replace(claims=claims, readings=[])):
        lines += block.items if isinstance(block, Bullets) else [block.text]
    return lines


@pytest.mark.parametrize(
    ("verdicts", "counted"),
    [
        (["holds"], "Of 1 claims of the paper, 1 holds. "),
        (["holds", "opposite"], "Of 2 claims of the paper, 1 holds and 1 is turned into its opposite. "),
        (
            ["holds", "does not hold", "does not hold", "depends on the map"],
            "Of 4 claims of the paper, 1 holds, 2 do not hold and 1 depends on the map. ",
        ),
    ],
)
def test_claims_are_counted_by_their_verdicts(found: Findings, verdicts: list[str], counted: str) -> None:
    assert said(found, [judged(verdict) for verdict in verdicts])[0].startswith(counted)


def test_averages_are_counted_by_algorithm_without_the_other_reading_of_x2(found: Findings) -> None:
    rows = [row for row in found.averages if row.printed.column != "x2_last"]
    of_pf = [row.inside for row in rows if row.printed.algorithm == "pf"]
    text = said(found, [judged("holds")])[0]
    assert f"Of 42 published averages, {sum(row.inside for row in rows)} lie where" in text
    assert f"ACO-PF {sum(of_pf)} of 6)." in text


def test_one_claim_about_several_maps_is_one_line(found: Findings) -> None:
    lines = said(found, [judged("holds", says=(1, 1, -1)), judged("holds", env="env2", says=(1, 0, 0))])
    assert (
        "ACO-PD loses fewer ants than standard ACO: "
        "fig13 A12 0.90 [0.80, 1.00], 2 of 3 further maps support it, 1 show the opposite; "
        "env2 A12 0.90 [0.80, 1.00], 1 of 3 further maps support it."
    ) in lines


def test_printed_numbers_are_gathered_in_a_line_of_their_own(found: Findings) -> None:
    lines = said(found, [judged("does not hold", CountIs("found", "aco", 5))])
    assert lines[1:3] == [
        "What does not hold, or was not shown",
        "Published numbers that ten of our trials would hardly have on most maps: "
        "Standard ACO finds the optimum in 5 of ten trials (fig13 A12 0.90 [0.80, 1.00]).",
    ]


def test_readings_are_compared_by_the_averages_that_they_meet(found: Findings) -> None:
    default, nearest = found.readings
    once, never = [claim.claim.key for claim in found.claims if claim.claim.kind.compares][:2]
    says = dict.fromkeys(default.says, 1) | {never: 0}
    some = nearest._replace(fit={(1, "fig13", "aco"): (36, 36)}, says=says | {once: 0})
    every = default._replace(says=says)
    blocks = summary(found._replace(readings=[every, some]))
    text = blocks[blocks.index(Heading("Other readings of the paper")) + 1].text
    assert f"Of 2 readings of what the paper leaves open, the defaults meet {default.inside} of 36" in text
    assert "and the best, field.obstacles=nearest, 36." in text
    compared = sum(c.claim.kind.compares and c.claim.key in default.says for c in found.claims)
    assert (
        f"Of {compared} comparisons of algorithms there, {compared - 2} come out as published under every" in text
    )
    assert "1 under none, 1 under some." in text


def test_it_rests_on_reconstructions_unless_all_true_maps_are_given(found: Findings) -> None:
    assert "so fig13, env1, env2 are reconstructions" in summary(found)[-1].text
    given = replace(found.experiment, given=frozenset(found.experiment.maps))
    assert "reconstructions" not in summary(found._replace(experiment=given))[-1].text
