"""How often the rule gives each verdict where the truth is known.

``python -m acoexp_paper.claims.characteristics``

Trials are drawn, not run. A comparison's two algorithms have normal values with equal spread on each map, as far
apart as its win share asks: the probability that the first does better. A printed number is the mean of ten
trials on a map of its own: a cycle, drawn from a geometric distribution whose mean is the map's. Maps that differ
have win shares, or mean cycles, that are drawn for each of them. All goes through the claims' own code; without
Holm's correction, which makes shown and contradicted rarer.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
import scipy  # scipy.stats is imported when first used

from acoexp.report.render import markdown_table
from acoexp.report.table import Table
from acoexp_paper.claims.comparisons import Fewer, superiority, verdict_of
from acoexp_paper.claims.means import rarity
from acoexp_paper.claims.pooling import over
from acoexp_paper.claims.statements import MeanIs, compatible_on, mean_effect, verdict_of_number
from acoexp_paper.claims.words import VERDICTS
from acoexp_paper.published.tables import TRIALS

MAPS = 22
"""As many as an ensemble has."""

_SMALLEST, _LARGEST = 0.02, 0.98
"""Win shares of maps that are drawn."""


class Truth(NamedTuple):
    """What is true of a claim.

    Attributes:
        text: It in words.
        centre: Mean over maps of the win share, or of the cycle.
        spread: Standard deviation between maps of the same; 0 for equal maps.
        printed: For a printed number, the mean cycle of the paper's map; None for a comparison.
    """

    text: str
    centre: float
    spread: float = 0.0
    printed: float | None = None


COMPARISONS = (
    Truth("no effect, alike on all maps", 0.50),
    Truth("true alike, win share 0.53", 0.53),
    Truth("true alike, win share 0.56", 0.56),
    Truth("true alike, win share 0.60", 0.60),
    Truth("true alike, win share 0.70", 0.70),
    Truth("false alike, win share 0.40", 0.40),
    Truth("no effect on the mean, ± 0.05 between maps", 0.50, 0.05),
    Truth("no effect on the mean, ± 0.15 between maps", 0.50, 0.15),
    Truth("true, 0.60 ± 0.05 between maps", 0.60, 0.05),
    Truth("true of most maps, 0.65 ± 0.10", 0.65, 0.10),
    Truth("true of nearly all maps, 0.80 ± 0.10", 0.80, 0.10),
)
PRINTED = (
    Truth("true alike: the paper's map is like ours", 10.0, 0.0, 10.0),
    Truth("false alike: printed of a map with half the mean", 10.0, 0.0, 5.0),
    Truth("false alike: printed of a map with twice the mean", 10.0, 0.0, 20.0),
    Truth("on the edge of 5 %, alike", 10.0, 0.0, 15.0),
    Truth("true: the paper's map is one of maps that differ, 10 ± 3", 10.0, 3.0, 10.0),
    Truth("true of some maps: 10 ± 5, printed of a map with half the mean", 10.0, 5.0, 5.0),
)


def frequencies(truth: Truth, trials: int, simulations: int, seed: int, maps: int = MAPS) -> dict[str, float]:
    """Return how often each verdict is given, as a share.

    Args:
        truth: What is true.
        trials: Trials of each algorithm on each map.
        simulations: How many claims are simulated.
        seed: Of the random numbers.
        maps: How many maps.
    """
    random = np.random.default_rng(seed)
    draw = _compared if truth.printed is None else _printed
    counts = Counter(draw(truth, trials, maps, random) for _ in range(simulations))
    return {verdict: counts[verdict] / simulations for verdict in VERDICTS}


def _compared(truth: Truth, trials: int, maps: int, random: np.random.Generator) -> str:
    shares = np.clip(random.normal(truth.centre, truth.spread, maps), _SMALLEST, _LARGEST)
    apart = 2.0**0.5 * scipy.stats.norm.ppf(shares)
    effects = [superiority(random.normal(-shift, 1.0, trials), random.normal(0.0, 1.0, trials)) for shift in apart]
    pooled = over(effects, Fewer.bounds)
    return verdict_of(pooled, Fewer.neutral, pooled.p_against(Fewer.neutral))


def _printed(truth: Truth, trials: int, maps: int, random: np.random.Generator) -> str:
    means = np.maximum(random.normal(truth.centre, truth.spread, maps), 1.5)
    values = [random.geometric(1.0 / mean, trials).astype(np.float64) for mean in means]
    assert truth.printed is not None
    papers = max(random.normal(truth.printed, truth.spread if truth.printed == truth.centre else 0.0), 1.5)
    number = float(random.geometric(1.0 / papers, TRIALS).mean())
    pooled = over([mean_effect(one) for one in values], MeanIs.bounds)
    return verdict_of_number(
        pooled, rarity(values, number), compatible_on(values, number) if pooled.differ else ()
    )


def table(truths: Sequence[Truth], trials: Sequence[int], simulations: int, seed: int) -> Table:
    """Return how often each verdict is given for each truth and number of trials, in per cent."""
    rows = [
        [
            truth.text,
            str(n),
            *(f"{100 * share:.1f}" for share in frequencies(truth, n, simulations, seed).values()),
        ]
        for truth in truths
        for n in trials
    ]
    note = f"Per cent of {simulations} simulated claims, {MAPS} maps, seed {seed}."
    return Table("How often each verdict is given.", note, ["truth", "trials a map", *VERDICTS], rows)


def _per_cent(share: float) -> str:
    return f"{100.0 * share:.1f}"


def _between(least: int, most: int) -> Callable[[str], int]:
    def whole_number(text: str) -> int:
        if not least <= (value := int(text)) <= most:
            raise argparse.ArgumentTypeError(f"expected a whole number from {least} to {most}; got {text!r}")
        return value

    return whole_number


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the tables as Markdown."""
    parser = argparse.ArgumentParser(prog="python -m acoexp_paper.claims.characteristics", description=__doc__)
    parser.add_argument(
        "--simulations", type=_between(1, 1_000_000), default=500, help="claims for each row (default: 500)"
    )
    parser.add_argument(
        "--trials", type=_between(2, 100_000), nargs="+", default=[100, 1000], help="a map (default: 100 1000)"
    )
    parser.add_argument("--seed", type=_between(0, 2**63), default=0, help="of the random numbers (default: 0)")
    given = parser.parse_args(arguments)
    for truths in (COMPARISONS, PRINTED):
        made = table(truths, given.trials, given.simulations, given.seed)
        print(f"{made.note}\n\n{markdown_table(made)}\n")


if __name__ == "__main__":
    main()
