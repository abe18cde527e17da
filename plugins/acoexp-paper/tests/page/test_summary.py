"""The summary, in words and in one table."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.comparisons import Fewer
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.kinds import Claim, Kind
from acoexp_paper.claims.pooling import Effect, Over
from acoexp_paper.claims.statements import CountIs
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.page.document import Bullets, Numbers, Text
from acoexp_paper.page.summary import summary
from acoexp_paper.trials.readings import SUM_IN

from acoexp.compare.statistics import Estimate

LOST = Fewer("lost ants", "pd", "aco")


def judged(verdict: str, kind: Kind = LOST, env: str = "fig13", fitted: bool = False) -> Judged:
    over = Over(Estimate(0.9, 0.8, 1.0), None, np.nan, 0.05, 1.0, 1.0)
    claim = Claim("", env, kind, fitted=fitted)
    return Judged(claim, 0.7, (Effect(0.9, 0.01),), over, None, 0.0, 0.0, verdict, (True,))


def said(found: Findings, claims: list[Judged]) -> list[str]:
    """Return all that the summary says, line by line."""
    lines = []
    for block in summary(found._replace(claims=claims, readings=[])):
        lines += block.items if isinstance(block, Bullets) else [block.text] if isinstance(block, Text) else []
    return lines


@pytest.mark.parametrize(
    ("verdicts", "counted"),
    [
        (["shown"], "Does the paper hold? Of 1 claims that the maps were not fitted to, 1 is shown."),
        (
            ["shown", "contradicted", "contradicted"],
            "Of 3 claims that the maps were not fitted to, 1 is shown and 2 are contradicted.",
        ),
        (
            ["shown", "compatible", "depends on the map", "undecided", "undecided"],
            "Of 5 claims that the maps were not fitted to, 1 is shown, 1 is compatible, 1 depends on the map "
            "and 2 stay undecided.",
        ),
    ],
)
def test_claims_are_counted_by_their_verdicts(found: Findings, verdicts: list[str], counted: str) -> None:
    assert said(found, [judged(verdict) for verdict in verdicts])[0].endswith(counted)


def test_it_begins_with_how_well_the_maps_meet_what_they_were_fitted_to(found: Findings) -> None:
    number = CountIs("found", "aco", 5)
    fitted = [judged(verdict, number, fitted=True) for verdict in ("compatible", "contradicted")]
    count, fit, *_ = said(found, [judged("shown"), *fitted])
    assert "Of 1 claims" in count
    assert f"fig13 {found.scores['fig13'][0]:.1f} (its 2 further maps" in fit
    assert "env1" not in fit
    assert "Of 2 claims about them, 1 is compatible" in fit


def test_true_maps_have_no_fit_to_speak_of(found: Findings) -> None:
    unknown = found._replace(scores={env: np.array([np.nan]) for env in found.scores})
    assert not any("reconstructions, fitted" in line for line in said(unknown, [judged("shown")]))


def test_what_came_of_two_algorithms_is_one_line_that_says_what_they_differ_in(found: Findings) -> None:
    settles = judged("undecided", Fewer("x3", "pd", "aco"))
    assert (
        "ACO-PD against standard ACO (what diffusion adds): of 3 comparisons, 2 are shown and 1 stays undecided."
    ) in said(found, [judged("shown"), judged("shown", env="env2"), settles])


def test_printed_numbers_are_counted_in_a_line_of_their_own(found: Findings) -> None:
    lines = said(found, [judged("contradicted", CountIs("found", "pd", 5)), judged("shown")])
    assert "Of 1 printed means and counts, 1 is contradicted." in lines


def test_averages_are_counted_by_algorithm_without_fitted_ones(found: Findings) -> None:
    rows = [row for row in found.averages if row.printed.column != "x2_last" and not row.printed.fitted]
    of_pf = [row.inside for row in rows if row.printed.algorithm == "pf"]
    (text,) = (line for line in said(found, [judged("shown")]) if "published averages" in line)
    assert f"Of 34 published averages that the maps were not fitted to, {sum(r.inside for r in rows)} lie" in text
    assert f"ACO-PF {sum(of_pf)} of 6); where the map is drawn from ours, " in text


def test_the_most_influential_decision_is_named(found: Findings) -> None:
    (nearest,) = found.readings
    key = next(iter(nearest.claims))
    source = nearest._replace(reading=SUM_IN, changed=(key,))
    _, bullets, *_ = summary(found._replace(readings=[source, nearest]))
    assert isinstance(bullets, Bullets)
    text = bullets.items[-1]
    assert f"another source changes 1 verdicts of {len(nearest.claims)} beyond chance (sum_in 1)." in text
    assert "No other reading changes any." in text
    more = summary(found._replace(readings=[source, nearest._replace(changed=(key,))]))[1].items[-1]
    assert "Of the other readings, field.obstacles=nearest changes most verdicts, 1." in more


def test_comparisons_alike_are_one_row_with_a_column_for_each_environment(found: Findings) -> None:
    claims = [
        judged("shown"),
        judged("shown", Fewer("x3", "pdg", "pd")),
        judged("undecided", env="env2"),
        judged("compatible", CountIs("found", "pd", 5)),
    ]
    *_, numbers, _ = summary(found._replace(claims=claims, readings=[]))
    assert isinstance(numbers, Numbers)
    assert numbers.table.headings == ["claim", "fig13", "env2"]
    assert numbers.table.rows == [
        ["ACO-PD loses fewer ants than standard ACO", "shown 0.90 (0.70)", "undecided 0.90 (0.70)"],
        ["ACO-PDG settles (x3) earlier than ACO-PD", "shown 0.90 (0.70)", ""],
    ]
