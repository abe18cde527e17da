"""What all maps say of each claim, on samples whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.catalogue import CLAIMS
from acoexp_paper.claims.comparisons import Fewer
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.statements import MeanIs
from acoexp_paper.claims.verdicts import corrected_p, judge
from acoexp_paper.trials.samples import Samples
from made import sample

QUICK: Samples = {"pdg": sample(5, seed=1), "pf": sample(9, seed=2)}
SLOW: Samples = {"pdg": QUICK["pf"], "pf": QUICK["pdg"]}
SOONER = Claim("", "env2", Fewer("hitting time", "pdg", "pf"))


def test_only_comparisons_are_corrected_and_for_their_number() -> None:
    p = corrected_p(CLAIMS, [0.01] * len(CLAIMS))
    family = sum(claim.kind.compares for claim in CLAIMS)
    assert sorted(p) == pytest.approx([0.01] * (len(CLAIMS) - family) + [min(1.0, 0.01 * family)] * family)


def test_each_map_counts_once_the_environments_own_first() -> None:
    (judged,) = judge([SOONER], {"env2": [QUICK, SLOW]})
    here, there = judged.effects
    assert here.value == pytest.approx(1.0 - there.value)
    assert judged.here.value == here.value
    assert judged.over.mean.value == pytest.approx(0.5)
    assert (judged.on_side, judged.better_on) == ((True, False), 0.5)


def test_weights_are_of_the_maps_and_stand_beside_the_plain_effect() -> None:
    (judged,) = judge([SOONER], {"env2": [QUICK, SLOW, SLOW]}, {"env2": np.array([0.5, 0.25, 0.25])})
    assert judged.weighted is not None
    assert judged.weighted.mean.value == pytest.approx(0.5)
    assert judged.over.mean.value < 0.4
    assert judge([SOONER], {"env2": [QUICK, SLOW]}, {"env2": None})[0].weighted is None


def test_a_map_without_the_number_is_as_none() -> None:
    never: Samples = {"pf": sample(found=0.0)}
    claim = Claim("", "env1", MeanIs("n_bar", "pf", 9.0))
    (judged,) = judge([claim], {"env1": [never, {"pf": QUICK["pf"]}]})
    assert judged.over.mean.value == judged.effects[1].value
    (nowhere,) = judge([claim], {"env1": [never]})
    assert nowhere.verdict == "contradicted"
    assert np.isnan(nowhere.over.mean.value)
