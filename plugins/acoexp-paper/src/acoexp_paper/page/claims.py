"""The section of claims: the verdicts and what they mean, and each effect on every map together."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from acoexp.report.table import Table, interval, number, p_value
from acoexp_paper.claims.pooling import Over
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.claims.words import MEANING
from acoexp_paper.page.document import Block, Bullets, Numbers, Text

_INTRO = (
    "A claim is judged by its effect on all maps of its environment together, each map counting once: a "
    "random-effects model, with equal weights, Hedges's estimate of the spread between maps, and Hartung and "
    "Knapp's interval. Own map: the environment's own alone, with the interval over its seeds; all maps: it and "
    "those of its ensemble; next map: the prediction interval, where the effect on one more such map lies."
)
_COMPARISONS = (
    "Trials with one seed share random numbers, so two algorithms are compared in pairs. A12 is the "
    "probability that the first does better, ties counted half; a trial that misses the optimum ranks behind "
    "all that find it. The shares' difference is that of the trials in which it happens. Paper: the same of "
    "the paper's own ten trials. p is of no effect, corrected over all comparisons (Holm); intervals are at 95 "
    "% and not corrected."
)
_PRINTED = (
    "Paper: the printed number. Ours: the mean, or how many of ten, on the own map and over all maps. p: how "
    "often the mean of ten of our trials, on a map drawn from ours, lies as far off as the printed one. * the "
    "maps were fitted to this number, which is therefore not counted."
)
_SPREAD = (
    "Spread: standard deviation of the effect between maps, without the noise of seeds. p (equal maps): of the "
    "maps having one effect. Better on: maps with the effect on the paper's side, or on which ten trials may "
    "well have the printed number. Weighted: the pooled effect with each map weighted by the likelihood of the "
    "rows it was fitted to; as many maps of equal weight would say as much, and below three there is no "
    "interval."
)
_FEW = 3
"""Maps of equal weight without which there is no interval worth printing."""


def claims(judged: Sequence[Judged]) -> list[Block]:
    """Return what came of every claim."""
    compare = [one for one in judged if one.claim.kind.compares]
    printed = [one for one in judged if not one.claim.kind.compares]
    ours = ["paper", "own map", "all maps", "next map", "p", "verdict"]
    rows = [
        [one.claim.text, one.claim.where, one.claim.map, one.claim.kind.measure, *_row(one)] for one in compare
    ]
    headings = ["claim", "where", "map", "effect", *ours]
    return [
        Text(_INTRO),
        Bullets([f"{word}: {meaning}." for word, meaning in MEANING.items()]),
        Numbers("comparisons", Table("Comparisons of two algorithms.", _COMPARISONS, headings, rows)),
        Numbers(
            "printed", Table("Printed numbers.", _PRINTED, ["claim", "where", "map", *ours], _printed(printed))
        ),
        Numbers("spread", _spread(judged)),
    ]


def _printed(judged: Sequence[Judged]) -> list[list[str]]:
    return [
        [one.claim.text + (" *" if one.claim.fitted else ""), one.claim.where, one.claim.map, *_row(one)]
        for one in judged
    ]


def _row(judged: Judged) -> list[str]:
    return [
        "-" if judged.published is None else number(judged.published),
        interval(*judged.here),
        interval(*judged.over.mean),
        next_map(judged.over),
        p_value(judged.p_holm),
        judged.verdict,
    ]


def next_map(over: Over) -> str:
    """Return the prediction interval; a dash with a single map."""
    return "-" if over.next is None else f"[{number(over.next[0])}, {number(over.next[1])}]"


def _spread(judged: Sequence[Judged]) -> Table:
    headings = [
        "claim",
        "map",
        "maps",
        "better on",
        "spread",
        "p (equal maps)",
        "all maps",
        "weighted",
        "as many maps",
    ]
    rows = [
        [
            one.claim.kind.text, one.claim.map, f"{one.over.maps:.0f}", f"{one.better_on:.0%}",
            number(one.over.spread), p_value(one.over.p_between), interval(*one.over.mean),
            *_weighted(one.weighted),
        ]
        for one in judged
    ]  # fmt: skip
    return Table("How far each effect depends on the map.", _SPREAD, headings, rows)


def _weighted(over: Over | None) -> list[str]:
    if over is None or np.isnan(over.mean.value):
        return ["-", "-"]
    mean = interval(*over.mean) if over.maps >= _FEW else number(over.mean.value)
    return [mean, f"{over.maps:.1f}"]
