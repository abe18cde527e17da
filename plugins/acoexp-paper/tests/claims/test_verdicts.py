"""Verdicts over maps, and on samples whose truth is known."""

from __future__ import annotations

from typing import Any

import pytest
from acoexp_paper.claims.catalogue import CLAIMS
from acoexp_paper.claims.comparisons import Fewer
from acoexp_paper.claims.kinds import Claim, Kind
from acoexp_paper.claims.statements import Every
from acoexp_paper.claims.verdicts import corrected_p, judge, says_of_maps, says_of_samples, verdict_over
from acoexp_paper.trials.samples import Samples
from made import sample

QUICK: Samples = {"pdg": sample(5, seed=1), "pf": sample(9, seed=2)}
SLOW: Samples = {"pdg": QUICK["pf"], "pf": QUICK["pdg"]}
SOONER = Fewer("hitting time", "pdg", "pf")


class KnownComparison(Fewer):
    """A comparison that is given p in place of samples."""

    def __init__(self) -> None:
        super().__init__("lost ants", "pdg", "pf")

    def p_and_effect(self, samples: Any) -> tuple[float, float]:
        return samples, 0.9


class KnownStatement(Every):
    """The same of a statement."""

    def __init__(self) -> None:
        super().__init__("found", "pdg")

    def p_and_effect(self, samples: Any) -> tuple[float, float]:
        return samples, 0.9


@pytest.mark.parametrize(
    ("says", "verdict"),
    [
        ([1] * 10, "holds"),
        ([1] * 8 + [0] * 2, "holds"),
        ([1] * 9 + [-1], "depends on the map"),
        ([1] * 5 + [0] * 5, "depends on the map"),
        ([1] + [0] * 9, "does not hold"),
        ([0] * 3, "does not hold"),
        ([-1] * 9 + [0], "opposite"),
        ([1], "holds"),
        ([-1], "opposite"),
    ],
)
def test_a_verdict_over_maps(says: list[int], verdict: str) -> None:
    assert verdict_over(says) == verdict


def test_only_comparisons_are_corrected_and_for_their_number() -> None:
    p = corrected_p(CLAIMS, [0.01] * len(CLAIMS))
    family = sum(claim.kind.compares for claim in CLAIMS)
    assert sorted(p) == pytest.approx([0.01] * (len(CLAIMS) - family) + [0.01 * family] * family)


def test_the_environments_map_counts_as_one_of_all() -> None:
    (judged,) = judge([Claim("", "env2", SOONER)], {"env2": QUICK}, {"env2": [SLOW]})
    assert (judged.on_map, judged.says, judged.verdict) == ("holds", (-1,), "depends on the map")
    assert judged.finding == SOONER.test(QUICK)
    assert judged.over_maps == SOONER.test_over([SLOW])


def test_of_env1_the_ensemble_alone_counts() -> None:
    (judged,) = judge([Claim("", "env1", SOONER)], {"env1": QUICK}, {"env1": [SLOW]})
    assert (judged.on_map, judged.says, judged.verdict) == (None, (-1,), "opposite")
    assert judged.finding == judged.over_maps


@pytest.mark.parametrize("env", ["env1", "env2"])
def test_without_an_ensemble_the_environments_map_decides(env: str) -> None:
    (judged,) = judge([Claim("", env, SOONER)], {env: QUICK}, {env: []})
    assert (judged.on_map, judged.over_maps, judged.says, judged.verdict) == ("holds", None, (), "holds")


@pytest.mark.parametrize(
    ("kind", "p", "says"),
    [
        (KnownComparison, [0.02], (1,)),
        (KnownComparison, [0.02, 0.5, 0.5], (0, 0, 0)),
        (KnownStatement, [0.02, 0.5, 0.5], (0, 1, 1)),
        (KnownStatement, [], ()),
        (KnownComparison, [], ()),
    ],
)
def test_comparisons_alone_are_corrected_for_the_number_of_maps(
    kind: type[Kind], p: list[float], says: tuple[int, ...]
) -> None:
    assert says_of_maps(Claim("", "env2", kind()), p) == says  # type: ignore[arg-type]


def test_samples_say_nothing_of_claims_about_what_is_not_among_them() -> None:
    claims = [Claim("", "env2", SOONER), Claim("", "env2", Every("found", "aco")), Claim("", "env1", SOONER)]
    assert says_of_samples(claims, {"env2": SLOW}) == {claims[0].key: -1}
