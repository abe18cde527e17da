"""Verdicts: what the trials say of each claim, on the environment's map and over its ensemble."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from acoexp.report.statistics import holm
from acoexp_paper.claims import CLAIMS, Claim
from acoexp_paper.experiment import Experiment
from acoexp_paper.kinds import Finding, Samples

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


def judge(experiment: Experiment) -> list[Judged]:
    """Judge all claims."""
    findings = []
    for claim in CLAIMS:
        maps = experiment.ensembles[claim.map]
        over = claim.kind.test_over(maps) if maps else None
        alone = over is not None and claim.map == "env1"  # of whose map nothing but the optimum is known
        findings.append((over if over is not None and alone else _on_map(experiment, claim), over, alone))
    corrected = corrected_p(CLAIMS, [finding.p for finding, _, _ in findings])
    judged = []
    for claim, (finding, over, alone), p in zip(CLAIMS, findings, corrected, strict=True):
        says = says_of_maps(claim, experiment.ensembles[claim.map])
        here = claim.kind.says(p, finding.effect.value)
        verdict = verdict_over(says if alone else (here, *says))
        judged.append(Judged(claim, finding, p, None if alone else _OF_ONE_MAP[here], over, says, verdict))
    return judged


def _on_map(experiment: Experiment, claim: Claim) -> Finding:
    return claim.kind.test(experiment.main[claim.map])


def corrected_p(claims: Sequence[Claim], p: Sequence[float]) -> list[float]:
    """Return p values, those of comparing claims corrected over their family by Holm's procedure."""
    family = [i for i, claim in enumerate(claims) if claim.kind.compares]
    corrected = dict(zip(family, holm([p[i] for i in family]), strict=True))
    return [corrected.get(i, value) for i, value in enumerate(p)]


def says_of_maps(claim: Claim, maps: Sequence[Samples]) -> tuple[int, ...]:
    """Return what each map says of a claim, 1, 0 or -1; a comparing one's p values are corrected over the maps."""
    seen = [claim.kind.glance(samples) for samples in maps]
    p = [p for p, _ in seen]
    corrected = holm(p) if claim.kind.compares and p else p
    return tuple(claim.kind.says(p, effect) for p, (_, effect) in zip(corrected, seen, strict=True))


def says_of_reading(samples: Mapping[str, Samples]) -> dict[str, int]:
    """Return what the samples of one reading, by environment, say of each claim that they can judge, by key."""
    claims = [c for c in CLAIMS if c.map in samples and set(c.kind.algos) <= samples[c.map].keys()]
    seen = [claim.kind.glance(samples[claim.map]) for claim in claims]
    corrected = corrected_p(claims, [p for p, _ in seen])
    return {c.key: c.kind.says(p, e) for c, p, (_, e) in zip(claims, corrected, seen, strict=True)}


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
