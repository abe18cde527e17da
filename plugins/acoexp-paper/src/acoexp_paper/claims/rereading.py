"""What becomes of the averages and claims under other readings of the paper, over all maps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from acoexp.compare.statistics import SIGNIFICANCE, Estimate, holm
from acoexp_paper.claims.averages import Fit, averages_met
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.pooling import Effect, over
from acoexp_paper.claims.verdicts import Judged, judge
from acoexp_paper.trials.readings import Maps, Reading
from acoexp_paper.trials.samples import Samples


class Reread(NamedTuple):
    """A claim under a reading.

    Attributes:
        judged: What comes of it.
        change: By how much its effect changes, on the same maps and seeds, with Student's interval over maps; nan
            where it does not.
        p: Two-sided p of no change; 1 where there is none.
    """

    judged: Judged
    change: Estimate
    p: float


class Outcome(NamedTuple):
    """What a reading leads to.

    Attributes:
        reading: The reading.
        maps: By environment, how many maps it fits.
        fit: By table, map and algorithm, how many published averages lie inside over these maps, of how many.
        claims: By key, the claims that can be judged under it.
        changed: The keys of those whose verdict and effect it changes; p of the changes corrected over all
            readings.
    """

    reading: Reading
    maps: dict[str, int]
    fit: Fit
    claims: dict[str, Reread]
    changed: tuple[str, ...] = ()

    @property
    def inside(self) -> int:
        """How many published averages lie inside."""
        return sum(inside for inside, _ in self.fit.values())

    @property
    def averages(self) -> int:
        """Of how many."""
        return sum(of for _, of in self.fit.values())


def outcome(
    reading: Reading, claims: Sequence[Claim], maps: Maps, default: Mapping[str, Sequence[Samples]]
) -> Outcome:
    """Judge a reading.

    Args:
        reading: The reading.
        claims: The claims; those about other environments or algorithms are left out.
        maps: Its samples on each map of each environment.
        default: Those of the defaults with the same seeds.
    """
    there = {env: [samples for samples in of_env if samples is not None] for env, of_env in maps.items()}
    there = {env: samples for env, samples in there.items() if samples}
    judged = judge([claim for claim in claims if _can_judge(claim, there)], there)
    counts = {env: len(there.get(env, ())) for env in maps}
    return Outcome(reading, counts, averages_met(there), {j.claim.key: _reread(j, maps, default) for j in judged})


def _can_judge(claim: Claim, maps: Mapping[str, Sequence[Samples]]) -> bool:
    return claim.map in maps and set(claim.kind.algos) <= maps[claim.map][0].keys()


def _reread(judged: Judged, maps: Maps, default: Mapping[str, Sequence[Samples]]) -> Reread:
    kind, env = judged.claim.kind, judged.claim.map
    pairs = zip(maps[env], default[env], strict=True)
    before = [kind.effect(unchanged) for samples, unchanged in pairs if samples is not None]
    return Reread(judged, *_change(before, judged.effects))


def _change(before: Sequence[Effect], after: Sequence[Effect]) -> tuple[Estimate, float]:
    changes = [Effect(new.value - old.value, 0.0) for old, new in zip(before, after, strict=True)]
    known = [change for change in changes if not np.isnan(change.value)]
    if len(known) < 2 or not any(change.value for change in known):
        return Estimate(np.nan, np.nan, np.nan), 1.0
    found = over(known, (-np.inf, np.inf))
    return found.mean, found.p_against(0.0)


def with_changes(outcomes: Sequence[Outcome], verdicts: Mapping[str, str]) -> list[Outcome]:
    """Return outcomes with the claims that they change.

    Args:
        outcomes: What the readings lead to.
        verdicts: By claim, the verdict under the defaults.
    """
    p = iter(holm([reread.p for one in outcomes for reread in one.claims.values()]))
    return [
        one._replace(changed=tuple(_changed(one, verdicts, [next(p) for _ in one.claims]))) for one in outcomes
    ]


def _changed(outcome: Outcome, verdicts: Mapping[str, str], p: Sequence[float]) -> list[str]:
    return [
        key
        for (key, reread), corrected in zip(outcome.claims.items(), p, strict=True)
        if corrected < SIGNIFICANCE and reread.judged.verdict != verdicts[key]
    ]
