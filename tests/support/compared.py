"""Trials made up for comparisons: of configurations on maps, cycle by cycle."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from acoexp.compare.sample import Sample
from acoexp.trial.features import NAMES

LOST = float("nan")


def sample(
    curves: Sequence[Sequence[float]],
    configuration: str = "c",
    name: str = "yard",
    optimum: float = 10.0,
    steps: Sequence[Sequence[int]] | None = None,
) -> Sample:
    """Return trials whose cycles found paths of such lengths, ``LOST`` where all ants were lost.

    Args:
        curves: A list for each trial, a length for each cycle.
        configuration: The configuration's label.
        name: The map's name.
        optimum: Its optimum.
        steps: Ant steps of each cycle; a hundred if not given.
    """
    found = np.array(curves, dtype=np.float64)
    made = np.full(found.shape, 100) if steps is None else np.array(steps)
    best = np.array([min((x for x in row if x == x), default=LOST) for row in found.tolist()])
    features = {"x1": np.ones(len(found)), "x2": np.ones(len(found)), "x3": np.ones(len(found)), "l1": best}
    features |= {"l2": found[:, -1], "lost_ants": np.zeros(len(found))}
    features |= {name: features.get(name, np.full(len(found), np.nan)) for name in NAMES}
    features["cycles"] = np.full(len(found), float(found.shape[1]))
    return Sample(configuration, name, optimum, best == optimum, features, found, made.cumsum(axis=1))


def maps_of(gaps: Sequence[Sequence[float]], labels: Sequence[str], trials: int = 4) -> list[list[Sample]]:
    """Return samples of maps on which all trials of a configuration end with one gap each; inf for no path."""
    return [
        [
            sample([[LOST if gap == float("inf") else 10.0 * (1.0 + gap)] * 3] * trials, label, f"map-{number}")
            for gap, label in zip(row, labels, strict=True)
        ]
        for number, row in enumerate(gaps)
    ]
