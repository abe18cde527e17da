"""The section of claims: what each test found, on the environment's map and over its ensemble, and the verdict."""

from __future__ import annotations

from collections.abc import Sequence

from acoexp.report.table import Table, interval, p_value
from acoexp_paper.claims.kinds import Finding
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.page.document import Block, Numbers, Text

_VERDICTS = (
    "A claim holds, or its opposite does, if at least four fifths of the maps say so and none says the "
    "contrary; it depends on the map if some maps support it and others show the opposite, or if between a "
    "fifth and four fifths do either; otherwise it does not hold, which for a comparison means that it was "
    "not shown."
)
_NOTE = (
    "Trials with one seed share random numbers, so two algorithms are compared in pairs: A12 is the "
    "probability that the first does better, ties counted half; the odds ratio is above 1 if it succeeds "
    "more often. A trial that misses the optimum ranks behind all that find it. p of comparing claims is "
    "corrected over their family (Holm); claims about one algorithm are their own null hypothesis and are "
    'judged uncorrected. "Every" is held to mean 99 %. Maps: those of the ensemble that support the claim / '
    "show the opposite / neither; over the maps: the mean effect, each map counting once (for odds ratios the "
    "difference in shares). * the maps were fitted to this number."
)
_HEADINGS = ["claim", "where", "map", "test", "p", "effect", "on the map", "maps", "over the maps", "verdict"]


def claims(judged: Sequence[Judged]) -> list[Block]:
    """Return what came of every claim."""
    table = Table("Claims of Sects 4 to 6.", _NOTE, _HEADINGS, [_row(one) for one in judged])
    return [Text(_VERDICTS), Numbers("claims", table)]


def _row(judged: Judged) -> list[str]:
    claim, finding = judged.claim, judged.finding
    return [
        claim.text + (" *" if claim.fitted else ""),
        claim.where,
        claim.map,
        finding.statistic,
        p_value(judged.p_holm),
        f"{finding.measure} {interval(*finding.effect)}",
        judged.on_map or "-",
        _maps(judged.says),
        _over_maps(judged.over_maps),
        judged.verdict,
    ]


def _maps(says: Sequence[int]) -> str:
    return f"{says.count(1)} / {says.count(-1)} / {says.count(0)}" if says else "-"


def _over_maps(finding: Finding | None) -> str:
    return "-" if finding is None else f"{interval(*finding.effect)}, p {p_value(finding.p)}"
