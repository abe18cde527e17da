"""Trials: what many trials of one cell found, as columns; the form in which batches are kept and compared."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from io import BytesIO
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.features import features_of
from acoexp.grid import path_length
from acoexp.result import Result

TABLE = np.dtype(
    [
        ("seed", np.uint64),
        ("x1", np.int32),
        ("x2", np.int32),
        ("x3", np.int32),
        ("l1", np.float64),
        ("l2", np.float64),
        ("lost_ants", np.int64),
        ("ant_steps", np.int64),
    ]
)
"""One row for each trial: x1, x2, x3 0 and l1, l2 nan where undefined; lost ants over all cycles."""


@dataclass(frozen=True, eq=False)
class Trials:
    """Trials of one cell, in the order of their seeds.

    Attributes:
        seeds: uint64[n].
        curve_pairs: int[n, iterations, 2], (straight, diagonal) moves of the best path found in each cycle; -1
            where all ants were lost.
        lost_ants: int[n, iterations], ants lost in each cycle.
        ant_steps: int64[n], moves made by all ants together.
    """

    seeds: NDArray[np.uint64]
    curve_pairs: NDArray[Any]
    lost_ants: NDArray[Any]
    ant_steps: NDArray[np.int64]

    @classmethod
    def of(cls, results: Sequence[Result]) -> Trials:
        """Return what one or more results leave behind."""
        ordered = sorted(results, key=lambda result: result.seed)
        return cls(
            seeds=np.array([r.seed for r in ordered], dtype=np.uint64),
            curve_pairs=_smallest(np.array([r.curve_pairs for r in ordered])),
            lost_ants=_smallest(np.array([r.lost_ants for r in ordered])),
            ant_steps=np.array([r.ant_steps for r in ordered], dtype=np.int64),
        )

    @classmethod
    def joined(cls, parts: Iterable[Trials]) -> Trials:
        """Return the trials of all parts, one or more; of several with one seed the first."""
        there = list(parts)
        seeds, place = np.unique(np.concatenate([p.seeds for p in there]), return_index=True)
        columns = [np.concatenate([getattr(p, name) for p in there])[place] for name in _COLUMNS[1:]]
        return cls(seeds, *columns)

    def among(self, seeds: NDArray[np.uint64]) -> Trials:
        """Return those whose seeds are among these."""
        wanted = np.isin(self.seeds, seeds)
        return Trials(*(getattr(self, name)[wanted] for name in _COLUMNS))

    def __len__(self) -> int:
        return int(self.seeds.size)

    @cached_property
    def curves(self) -> NDArray[np.float64]:
        """Best length found in each cycle, float[n, iterations]; nan where all ants were lost."""
        straight, diagonal = np.moveaxis(self.curve_pairs.astype(np.float64), -1, 0)
        return np.where(straight < 0, np.nan, path_length(straight, diagonal))

    @cached_property
    def table(self) -> NDArray[np.void]:
        """The features, one row for each trial, of type ``TABLE``."""
        table = np.zeros(len(self), dtype=TABLE)
        table["seed"], table["ant_steps"] = self.seeds, self.ant_steps
        table["lost_ants"] = self.lost_ants.sum(axis=1)
        for row, curve in zip(table, self.curves, strict=True):
            features = features_of(curve)
            for name in ("x1", "x2", "x3", "l1", "l2"):
                row[name] = getattr(features, name)
        return table

    def to_bytes(self) -> bytes:
        """Return all columns as NumPy's compressed archive."""
        buffer = BytesIO()
        np.savez_compressed(buffer, **{name: getattr(self, name) for name in _COLUMNS})
        return buffer.getvalue()

    @classmethod
    def from_bytes(cls, content: bytes) -> Trials:
        """Return what :func:`to_bytes` wrote.

        Raises:
            ValueError: if it is damaged, as it is where a process was killed while it wrote.
        """
        try:
            with np.load(BytesIO(content)) as archive:
                return cls(*(archive[name] for name in _COLUMNS))
        except Exception as problem:
            raise ValueError(f"no archive of trials: {problem}") from problem


_SLICE = 10_000  # rows in memory as Python's numbers at a time
_COLUMNS = ("seeds", "curve_pairs", "lost_ants", "ant_steps")


class Aggregates(NamedTuple):
    """What a cell's trials say together.

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


def aggregate(table: NDArray[np.void], optimum: float, iterations: int) -> Aggregates:
    """Return the aggregates of one or more trials, a table of type ``TABLE``."""
    found = table["l1"] == optimum
    spent = np.where(found, table["x1"], iterations).sum()
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
    for row in (row for first in range(0, len(table), _SLICE) for row in table[first : first + _SLICE].tolist()):
        seed, *cycles_and_lengths, lost, steps = row
        shown = ["" if value == 0 or value != value else repr(value) for value in cycles_and_lengths]
        yield ",".join([str(seed), *shown, str(lost), str(steps)])


def _defined(table: NDArray[np.void]) -> Iterator[tuple[str, NDArray[np.float64]]]:
    """Yield each feature's name and the values in the trials in which it is defined."""
    for name in ("x1", "x2", "x3", "l1", "l2", "lost_ants"):
        values = table[name].astype(np.float64)
        undefined = values == 0 if name in ("x1", "x2", "x3") else np.isnan(values)
        yield name, values[~undefined]


def _smallest(values: NDArray[Any]) -> NDArray[Any]:
    """Return values in the smallest type of whole numbers that holds them."""
    return values.astype(np.int16 if values.max(initial=0) <= np.iinfo(np.int16).max else np.int32)
