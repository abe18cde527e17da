"""The table of trials: their features, a row for each, and what they say together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.trial.features import CYCLES, NAMES, defined
from acoexp.trial.quality import Quality

TABLE = np.dtype(
    [
        ("seed", np.uint64),
        ("x1", np.int32),
        ("x2", np.int32),
        ("x3", np.int32),
        ("l1", np.float64),
        ("l2", np.float64),
        *((name, np.float64) for name in Quality._fields),
        ("cycles", np.int32),
        ("lost_ants", np.int64),
        ("ant_steps", np.int64),
    ]
)
"""One row for each trial: x1, x2, x3 0 and other features nan where undefined; lost ants over all cycles."""

_SLICE = 10_000  # rows in memory as Python's numbers at a time


class Aggregates(NamedTuple):
    """What a configuration's trials say together.

    Attributes:
        trials: How many there are.
        never_arrived: Those in which no ant ever reached the goal.
        success_rate: Share that found the optimum, from 0 to 1.
        expected_cycles: Cycles spent by all trials per success, that is the expected running time of restarts;
            nan if there is no success.
        means: Mean of each feature over the trials in which it is defined.
        deviations: The sample's standard deviation, likewise; nan for fewer than two.
    """

    trials: int
    never_arrived: int
    success_rate: float
    expected_cycles: float
    means: dict[str, float]
    deviations: dict[str, float]


def aggregate(table: NDArray[np.void], optimum: float) -> Aggregates:
    """Return the aggregates of one or more trials, a table of type ``TABLE``."""
    found = table["l1"] == optimum
    spent = np.where(found, table["x1"], table["cycles"]).sum()
    columns = dict(_defined(table))
    return Aggregates(
        trials=len(table),
        never_arrived=int(np.isnan(table["l1"]).sum()),
        success_rate=float(found.mean()),
        expected_cycles=float(spent / found.sum()) if found.any() else np.nan,
        means={name: float(values.mean()) if values.size else np.nan for name, values in columns.items()},
        deviations={n: float(values.std(ddof=1)) if values.size > 1 else np.nan for n, values in columns.items()},
    )


def csv_lines(table: NDArray[np.void]) -> Iterator[str]:
    """Yield a table's heading and rows as lines of CSV; what is undefined stays empty."""
    yield ",".join(TABLE.names or ())
    names = table.dtype.names or ()
    for row in (row for first in range(0, len(table), _SLICE) for row in table[first : first + _SLICE].tolist()):
        pairs = zip(names, row, strict=True)
        yield ",".join("" if v != v or (v == 0 and name in CYCLES) else repr(v) for name, v in pairs)


def _defined(table: NDArray[np.void]) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Yield each feature's name and the values in the trials in which it is defined."""
    for name in NAMES:
        values = defined(name, table[name])
        yield name, values[~np.isnan(values)]
