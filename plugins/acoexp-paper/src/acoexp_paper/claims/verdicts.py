"""Verdicts: what the trials on all maps of an environment say of each claim."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from acoexp.compare.statistics import Estimate, Values, holm
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.pooling import Effect, Over, over
from acoexp_paper.trials.samples import Samples


class Judged(NamedTuple):
    """A claim and what came of it.

    Attributes:
        claim: The claim.
        published: The effect in the paper's own ten trials; None where it prints none.
        effects: The effect on each map, the environment's own map first; nan where there is none.
        over: Their pooled effect.
        weighted: The same with the maps weighted by their likelihood; None where that is not known.
        p: The p value of the claim's null hypothesis.
        p_holm: The same corrected over all comparing claims; as it is for the others.
        verdict: The verdict.
        on_side: Whether each map is on the paper's side: its effect, or that ten trials may have the number there.
    """

    claim: Claim
    published: float | None
    effects: tuple[Effect, ...]
    over: Over
    weighted: Over | None
    p: float
    p_holm: float
    verdict: str
    on_side: tuple[bool, ...]

    @property
    def better_on(self) -> float:
        """The share of maps that are on the paper's side."""
        return float(np.mean(self.on_side))

    @property
    def here(self) -> Estimate:
        """The effect on the environment's own map, with its interval over seeds."""
        return over(self.effects[:1], self.claim.kind.bounds).mean


def judge(
    claims: Sequence[Claim],
    maps: Mapping[str, Sequence[Samples]],
    weights: Mapping[str, Values | None] | None = None,
) -> list[Judged]:
    """Judge claims.

    Args:
        claims: The claims; the p values of those that compare are corrected for their number.
        maps: The samples on each map of each environment, its own map first.
        weights: Those of the maps, by environment; None where there are none.
    """
    weights = weights or {}
    effects = [tuple(claim.kind.effect(samples) for samples in maps[claim.map]) for claim in claims]
    overs = [_over(claim, one, None) for claim, one in zip(claims, effects, strict=True)]
    p = [claim.kind.p(maps[claim.map], one) for claim, one in zip(claims, overs, strict=True)]
    return [
        Judged(
            claim,
            claim.kind.published(claim.map),
            effects[i],
            overs[i],
            None if weights.get(claim.map) is None else _over(claim, effects[i], weights[claim.map]),
            p[i],
            p_holm,
            claim.kind.verdict(maps[claim.map], overs[i], p_holm),
            claim.kind.on_side(maps[claim.map], effects[i]),
        )
        for i, (claim, p_holm) in enumerate(zip(claims, corrected_p(claims, p), strict=True))
    ]


def _over(claim: Claim, effects: Sequence[Effect], weights: Values | None) -> Over:
    """Pool the maps that have the effect; one that has none is as nothing."""
    known = np.array([not np.isnan(effect.value) for effect in effects])
    if not known.any():
        return Over(Estimate(np.nan, np.nan, np.nan), None, np.nan, np.nan, 0.0, 1.0)
    there = [effect for effect, is_known in zip(effects, known, strict=True) if is_known]
    return over(there, claim.kind.bounds, None if weights is None else weights[known])


def corrected_p(claims: Sequence[Claim], p: Sequence[float]) -> list[float]:
    """Return p values, those of comparing claims corrected over their family by Holm's procedure."""
    family = [i for i, claim in enumerate(claims) if claim.kind.compares]
    corrected = dict(zip(family, holm([p[i] for i in family]), strict=True))
    return [corrected.get(i, value) for i, value in enumerate(p)]
