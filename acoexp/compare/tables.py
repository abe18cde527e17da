"""The tables that a person reads: features, success, and pairs, each number with its spread or interval."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from acoexp.compare.sample import Row
from acoexp.report.table import Table, interval, p_value


def tables_of(rows: Sequence[Row], pairs: Sequence[Row]) -> list[Table]:
    """Return the report's tables from its rows."""
    return [features_table(rows), success_table(rows), quality_table(rows), pairs_table(pairs)]


def features_table(rows: Sequence[Row]) -> Table:
    """Return the features, mean ± standard deviation."""
    digits = {"x1": 1, "x2": 1, "x3": 1, "l1": 4, "l2": 4, "lost_ants": 1}
    note = (
        "Mean ± standard deviation over trials. x1, x2, x3: cycles; l1, l2, optimum: cells; lost ants: per trial. "
        "A trial without a value is left out of that mean."
    )
    texts = [
        [row["map"], row["cell"], *(_spread(row, name, d) for name, d in digits.items()), f"{row['optimum']:.4f}"]
        for row in rows
    ]
    return Table("Features", note, ["map", "cell", "x1", "x2", "x3", "l1", "l2", "lost ants", "optimum"], texts)


def success_table(rows: Sequence[Row]) -> Table:
    """Return how often and how soon the exact optimum was found."""
    note = (
        "Trials that found the exact optimum, their share with Wilson's interval, and the expected running time: "
        "cycles spent by all trials per success, with its bootstrap interval. All intervals are at 95 %."
    )
    texts = [
        [
            row["map"],
            row["cell"],
            f"{row['found']}/{row['trials']}",
            interval(row["success"], row["success_low"], row["success_high"]),
            interval(row["ert"], row["ert_low"], row["ert_high"]),
        ]
        for row in rows
    ]
    headings = ["map", "cell", "found", "success rate", "expected running time (cycles)"]
    return Table("Success", note, headings, texts)


def quality_table(rows: Sequence[Row]) -> Table:
    """Return how good the paths are to drive, mean ± standard deviation."""
    digits = {"turns": 1, "turning": 2, "clearance_mean": 2, "clearance_least": 2, "detour": 3}
    note = (
        "Of each trial's best path, mean ± standard deviation over trials: turns; turning in radians; mean and "
        "least distance from the centres of its cells to that of the nearest obstacle, in cells; detour: its "
        "length over the exact shortest any-angle path's, - where that was not computed."
    )
    texts = [[row["map"], row["cell"], *(_spread(row, name, d) for name, d in digits.items())] for row in rows]
    headings = ["map", "cell", "turns", "turning", "mean clearance", "least clearance", "detour"]
    return Table("Quality of paths", note, headings, texts)


def learning_table(rows: Sequence[Row]) -> Table:
    """Return how much of a result is the colony's."""
    note = (
        "Where paths are optimised after the walk: by how much the best path exceeds the exact optimum, mean over "
        "the trials that arrived (in brackets, if not all did). Cycle 1: the first ants, among whom pheromone may "
        "diffuse already. alpha = 0: all cycles, but ants never see pheromone. What the last column gains on that "
        "is learned; the rest is the optimiser's, the heuristic's, and that of many tries."
    )
    gaps = {"first": "cycle 1", "blind": "alpha = 0", "learned": "the run"}
    texts = [[row["map"], row["cell"], *(_percent(row, name) for name in gaps)] for row in rows]
    return Table("What the colony learns", note, ["map", "cell", *gaps.values()], texts)


def pairs_table(pairs: Sequence[Row]) -> Table:
    """Return effect sizes, tests and verdicts."""
    note = (
        "A12: probability that a trial of a does better than one of b, ties counted half; bootstrap interval over "
        "seeds. Odds ratio of success: above 1 if a succeeds more often; exact interval. Tests pair the trials "
        "with the same seed: the exact sign test, for success McNemar's. Hitting time: x1 of trials "
        "that found the optimum, the others rank behind. Holm: p corrected for all tests of this table; verdicts "
        "at 5 %."
    )
    rows = [
        [
            *(row[key] for key in ("map", "a", "b", "measure", "effect")),
            interval(row["value"], row["low"], row["high"]),
            row["test"],
            p_value(row["p"]),
            p_value(row["p_holm"]),
            row["verdict"],
        ]
        for row in pairs
    ]
    headings = ["map", "a", "b", "measure", "effect", "size", "test", "p", "p (Holm)", "verdict"]
    return Table("Pairs", note, headings, rows)


def _spread(row: Row, name: str, digits: int) -> str:
    mean, deviation = row[name], row[f"{name}_sd"]
    if np.isnan(mean):
        return "-"
    return f"{mean:.{digits}f}" if np.isnan(deviation) else f"{mean:.{digits}f} ± {deviation:.{min(digits, 2)}f}"


def _percent(row: Row, name: str) -> str:
    if np.isnan(row[name]):
        return "-"
    arrived = row[f"{name}_arrived"]
    return f"{100 * row[name]:.2f} %" + ("" if arrived == row["trials"] else f" ({arrived})")
