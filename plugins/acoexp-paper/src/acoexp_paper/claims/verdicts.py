"""Verdicts: what the trials say of each claim, on the environment's map and over its ensemble."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from acoexp.compare.statistics import holm
from acoexp_paper.claims.kinds import Claim, Finding
from acoexp_paper.published.tables import ENVIRONMENTS
from acoexp_paper.trials.samples import Samples

HOLDS, FAILS, OPPOSITE, DEPENDS = "holds", "does not hold", "opposite", "depends on the map"
VERDICTS = (HOLDS, FAILS, OPPOSITE, DEPENDS)

_OF_ONE_MAP = {1: HOLDS, 0: FAILS, -1: OPPOSITE}
_NEARLY_ALL, _HARDLY_ANY = 0.8, 0.2


class Judged(NamedTuple):
    """A claim and what came of it.

    Attributes:
        claim: The claim.
        finding: The test on the environment's map; over the ensemble where that alone counts.
        p_holm: Its p value, corrected over all comparing claims; as it is for the others.
        on_map: The verdict on the environment's map; None where the ensemble alone counts.
        over_maps: The test over the ensemble; None where there is none.
        says: What each map of the ensemble says, 1, 0 or -1.
        verdict: The verdict over all maps.
    """

    claim: Claim
    finding: Finding
    p_holm: float
    on_map: str | None
    over_maps: Finding | None
    says: tuple[int, ...]
    verdict: str


class _Tested(NamedTuple):
    """A claim and its tests, before the p values of all claims are corrected together."""

    claim: Claim
    finding: Finding
    over_maps: Finding | None
    says: tuple[int, ...]
    ensemble_alone: bool


def judge(
    claims: Sequence[Claim], main: Mapping[str, Samples], ensembles: Mapping[str, Sequence[Samples]]
) -> list[Judged]:
    """Judge claims.

    Args:
        claims: The claims; the p values of those that compare are corrected for their number.
        main: The samples on each environment's map.
        ensembles: Those on each of its further maps.
    """
    tested = [_test(claim, main[claim.map], ensembles[claim.map]) for claim in claims]
    corrected = corrected_p(claims, [test.finding.p for test in tested])
    return [_judged(test, p) for test, p in zip(tested, corrected, strict=True)]


def _test(claim: Claim, samples: Samples, ensemble: Sequence[Samples]) -> _Tested:
    says = says_of_maps(claim, ensemble)
    over_maps = claim.kind.test_over(ensemble) if ensemble else None
    if over_maps is not None and ENVIRONMENTS[claim.map].only_optimum:
        return _Tested(claim, over_maps, over_maps, says, ensemble_alone=True)
    return _Tested(claim, claim.kind.test(samples), over_maps, says, ensemble_alone=False)


def _judged(test: _Tested, p: float) -> Judged:
    claim, finding, over_maps, says, alone = test
    here = claim.kind.says(p, finding.effect.value)
    verdict = verdict_over(says if alone else (here, *says))
    return Judged(claim, finding, p, None if alone else _OF_ONE_MAP[here], over_maps, says, verdict)


def corrected_p(claims: Sequence[Claim], p: Sequence[float]) -> list[float]:
    """Return p values, those of comparing claims corrected over their family by Holm's procedure."""
    family = [i for i, claim in enumerate(claims) if claim.kind.compares]
    corrected = dict(zip(family, holm([p[i] for i in family]), strict=True))
    return [corrected.get(i, value) for i, value in enumerate(p)]


def says_of_maps(claim: Claim, maps: Sequence[Samples]) -> tuple[int, ...]:
    """Return what each map says of a claim, 1, 0 or -1; a comparing one's p values are corrected over the maps."""
    seen = [claim.kind.p_and_effect(samples) for samples in maps]
    p = [p for p, _ in seen]
    corrected = holm(p) if claim.kind.compares and p else p
    return tuple(claim.kind.says(p, effect) for p, (_, effect) in zip(corrected, seen, strict=True))


def says_of_samples(claims: Sequence[Claim], main: Mapping[str, Samples]) -> dict[str, int]:
    """Return what samples, by environment, say of each claim that they can judge, by its key: 1, 0 or -1."""
    judged = [c for c in claims if c.map in main and set(c.kind.algos) <= main[c.map].keys()]
    seen = [claim.kind.p_and_effect(main[claim.map]) for claim in judged]
    corrected = corrected_p(judged, [p for p, _ in seen])
    return {c.key: c.kind.says(p, e) for c, p, (_, e) in zip(judged, corrected, seen, strict=True)}


def verdict_over(says: Sequence[int]) -> str:
    """Return the verdict of many maps.

    It depends on the map if some support the claim and others show the opposite, or if between a fifth and four
    fifths do either; it holds, or is opposite, if more do.
    """
    support, oppose = (sum(s == side for s in says) / len(says) for side in (1, -1))
    if support and oppose:
        return DEPENDS
    if max(support, oppose) >= _NEARLY_ALL:
        return HOLDS if support else OPPOSITE
    return DEPENDS if max(support, oppose) > _HARDLY_ANY else FAILS
