"""The tables of the verdict over maps that a person reads."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from acoexp.compare.over_maps.verdict import Verdict
from acoexp.compare.sample import Row
from acoexp.report.table import Table, interval, number, p_value


def verdict_tables(verdict: Verdict) -> list[Table]:
    """Return the ranks, and the pairs where there are enough maps for a verdict."""
    return [ranks_table(verdict.ranks), *([pairs_table(verdict.pairs)] if verdict.pairs else [])]


def ranks_table(rows: Sequence[Row]) -> Table:
    """Return the mean ranks, from the best on."""
    note = (
        "On each map the configurations are ranked by one value each, the median over seeds of the gap "
        "between a trial's best path and the exact optimum; trials whose ants were all lost count as worst, "
        "and equal values share their ranks. Mean rank: 1 is the best; its interval is a bootstrap over maps. "
        "Best on: maps on which none is better. Lost on: maps on which half of the trials or more found no "
        "path. Gap: median over maps."
    )
    texts = [
        [
            row["cell"],
            interval(row["mean_rank"], row["low"], row["high"]),
            f"{row['best_on']}/{row['maps']}",
            f"{row['lost_on']}/{row['maps']}",
            percent(row["gap"]),
        ]
        for row in rows
    ]
    return Table("Ranks over maps", note, ["cell", "mean rank", "best on", "lost on", "gap"], texts)


def pairs_table(rows: Sequence[Row]) -> Table:
    """Return what is said of each two configurations over maps."""
    note = (
        "Wins, ties and losses of a, counted in maps by that value. A12: probability that a trial of a has a "
        "shorter path than one of b, ties counted half: the mean over maps, its interval (Student's, over "
        "maps), and where the next map's is to be expected (prediction interval). Maps weigh alike: by "
        "inverse variances a map on which one always wins would outweigh all others. Rank difference: mean "
        "rank of b less that of a. " + _TESTS[rows[0]["test"]]
    )
    texts = [
        [
            row["a"],
            row["b"],
            f"{row['wins']} / {row['ties']} / {row['losses']}",
            interval(row["a12"], row["low"], row["high"]),
            f"[{number(row['next_low'])}, {number(row['next_high'])}]",
            f"{row['rank_difference']:+.2f}",
            p_value(row["p"]),
            row["verdict"],
        ]
        for row in rows
    ]
    headings = ["a", "b", "wins / ties / losses", "A12", "next map", "rank difference", "p", "verdict"]
    return Table("Pairs over maps", note, headings, texts)


_TESTS = {
    "Nemenyi": "p: Nemenyi's test, corrected for all pairs; it is a verdict at 5 %, if Friedman's test is one.",
    "sign test": "p: the exact sign test over maps; verdict at 5 %.",
}


def percent(share: float) -> str:
    """Return a gap in per cent; a dash where there is no path."""
    return f"{number(100.0 * share)} %" if np.isfinite(share) else "-"
