"""The verdict over maps: which configurations are told apart, by one test of one value a map and configuration."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.compare.over_maps.pooling import effect, pooled
from acoexp.compare.over_maps.ranking import Friedman, Ranks, critical_difference, friedman, nemenyi, ranks_of
from acoexp.compare.over_maps.values import MapValues
from acoexp.compare.sample import Row, Sample
from acoexp.compare.statistics import SIGNIFICANCE, interval_of_means, sign_test
from acoexp.report.table import number, p_value

ENOUGH = 5
"""Maps that a verdict takes; fewer say nothing of further maps, however many seeds each has."""


class Verdict(NamedTuple):
    """What is said over maps.

    Attributes:
        text: It, in some sentences.
        ranks: A row for each configuration.
        pairs: A row for each two of them; none without enough maps.
        mean_ranks: float[configurations].
        friedman: The test of three or more configurations on enough maps; None where there is none.
        difference: Nemenyi's critical difference of mean ranks, likewise.
    """

    text: str
    ranks: list[Row]
    pairs: list[Row]
    mean_ranks: NDArray[np.float64]
    friedman: Friedman | None
    difference: float | None

    @property
    def differ(self) -> bool:
        """Whether Friedman's test tells any two apart."""
        return self.friedman is not None and self.friedman.f_p < SIGNIFICANCE


def verdict_over(maps: Sequence[Sequence[Sample]], values: MapValues) -> Verdict:
    """Return the verdict on the samples of each map, in the same order of configurations on each."""
    ranks = ranks_of(values.gaps)
    enough, count = len(maps) >= ENOUGH, len(values.configurations)
    test = friedman(ranks) if enough and count > 2 else None
    difference = critical_difference(count, len(maps)) if test is not None else None
    found = Verdict("", _rank_rows(values, ranks), [], ranks.mean(axis=0), test, difference)
    if not enough:
        return found._replace(text=_too_few(len(maps)))
    pairs = [_pair_row(maps, values, ranks, test, pair) for pair in combinations(range(count), 2)]
    return found._replace(pairs=pairs, text=_said(found, pairs, len(maps), bool((ranks == ranks[:, :1]).all())))


def _rank_rows(values: MapValues, ranks: Ranks) -> list[Row]:
    enough = len(ranks) >= ENOUGH
    low, high = interval_of_means(ranks) if enough else np.full((2, ranks.shape[1]), np.nan)
    best = values.gaps == values.gaps.min(axis=1, keepdims=True)
    rows: list[Row] = [
        {
            "cell": label,
            "mean_rank": float(ranks[:, place].mean()),
            "low": float(low[place]),
            "high": float(high[place]),
            "best_on": int((best[:, place] & np.isfinite(values.gaps[:, place])).sum()),
            "lost_on": int(np.isinf(values.gaps[:, place]).sum()),
            "maps": len(ranks),
            "gap": float(np.quantile(values.gaps[:, place], 0.5, method="inverted_cdf")),
        }
        for place, label in enumerate(values.configurations)
    ]
    return sorted(rows, key=lambda row: row["mean_rank"])


def _pair_row(
    maps: Sequence[Sequence[Sample]],
    values: MapValues,
    ranks: Ranks,
    test: Friedman | None,
    pair: tuple[int, int],
) -> Row:
    """Compare two configurations; of several, by ranks among all of them, once Friedman's test allows it."""
    first, second = pair
    a, b = values.gaps[:, first], values.gaps[:, second]
    means = float(ranks[:, first].mean()), float(ranks[:, second].mean())
    alone = ranks.shape[1] == 2
    p = sign_test(a, b) if alone else 1.0 if test is None else nemenyi(*means, ranks.shape[1], len(maps))
    effects = pooled(np.array([effect(samples[first], samples[second]) for samples in maps]))
    shown = p < SIGNIFICANCE and (alone or (test is not None and test.f_p < SIGNIFICANCE))
    labels = values.configurations
    better = labels[first] if means[0] < means[1] else labels[second]
    return {
        "a": labels[first],
        "b": labels[second],
        "wins": int((a < b).sum()),
        "ties": int((a == b).sum()),
        "losses": int((a > b).sum()),
        "rank_difference": means[1] - means[0],
        "a12": effects.mean.value,
        "low": effects.mean.low,
        "high": effects.mean.high,
        "next_low": effects.next_low,
        "next_high": effects.next_high,
        "test": "sign test" if alone else "Nemenyi",
        "p": p,
        "verdict": f"{better} better" if shown else "no difference shown",
    }


def _too_few(maps: int) -> str:
    what = "One map allows" if maps == 1 else f"{maps} maps allow"
    return (
        f"{what} no verdict over maps: it takes {ENOUGH} or more. What seeds show on a map, below, holds for "
        "that map; more seeds do not tell what is to be expected of another."
    )


def _said(found: Verdict, pairs: Sequence[Row], maps: int, all_tie: bool) -> str:
    if all_tie:
        return (
            f"No difference: on each of {maps} maps all configurations have the same median gap to the "
            "optimum, so there is nothing to rank."
        )
    order = ", ".join(f"{row['cell']} {row['mean_rank']:.2f}" for row in found.ranks)
    told = [row for row in pairs if row["verdict"].endswith(" better")]
    if len(found.ranks) == 2:
        (row,) = pairs
        counted = f"{row['a']} wins on {row['wins']}, {row['b']} on {row['losses']}, and {row['ties']} tie"
        outcome = f"{row['verdict'].removesuffix(' better')} is better" if told else "no difference is shown"
        return (
            f"Over {maps} maps: {outcome} (sign test over maps, p {_p(row['p'])}): {counted}. Mean ranks: {order}."
        )
    assert found.friedman is not None
    test = (
        f"Friedman: chi² = {number(found.friedman.chi2)}, Iman and Davenport's F = {number(found.friedman.f)}, "
        f"p {_p(found.friedman.f_p)}"
    )
    if not found.differ:
        return f"Over {maps} maps no difference is shown ({test}). Mean ranks, 1 the best: {order}."
    named = "; ".join(_told_apart(found.ranks, told))
    rest = "" if len(told) == len(pairs) else "; nothing else is told apart"
    nemenyi_said = f"{named}{rest}" if told else "no two of them can be told apart"
    return (
        f"Over {maps} maps the configurations differ ({test}). Mean ranks, 1 the best: {order}. By Nemenyi's "
        f"test, critical difference {number(found.difference or np.nan)}: {nemenyi_said}."
    )


def _told_apart(ranks: Sequence[Row], told: Sequence[Row]) -> Iterator[str]:
    """Say of each configuration, from the best to the worst, which ones are better."""
    for worse in (row["cell"] for row in ranks):
        better = [row["cell"] for row in ranks if any(_is(one, row["cell"], worse) for one in told)]
        if better:
            yield f"{_listed(better)} {'is' if len(better) == 1 else 'are'} better than {worse}"


def _is(row: Row, better: str, worse: str) -> bool:
    """Whether it is this pair, and this verdict on it."""
    return {row["a"], row["b"]} == {better, worse} and row["verdict"] == f"{better} better"


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _p(p: float) -> str:
    text = p_value(p)
    return text if text.startswith("<") else f"= {text}"
