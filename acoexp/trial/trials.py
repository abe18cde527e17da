"""Trials: what many trials of one configuration found, as columns; as batches are kept and compared."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.trial.features import curve_of, features_of
from acoexp.trial.result import Result
from acoexp.trial.table import TABLE

_COLUMNS = ("seeds", "curve_pairs", "lost_ants", "ant_steps")


@dataclass(frozen=True, eq=False)
class Trials:
    """Trials of one configuration, in the order of their seeds.

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
        given = list(parts)
        seeds, place = np.unique(np.concatenate([p.seeds for p in given]), return_index=True)
        columns = [np.concatenate([getattr(p, name) for p in given])[place] for name in _COLUMNS[1:]]
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
        return curve_of(self.curve_pairs)

    @cached_property
    def table(self) -> NDArray[np.void]:
        """The features, one row for each trial, of type ``TABLE``."""
        table = np.zeros(len(self), dtype=TABLE)
        table["seed"], table["ant_steps"] = self.seeds, self.ant_steps
        table["lost_ants"] = self.lost_ants.sum(axis=1)
        for row, curve in zip(table, self.curves, strict=True):
            features = features_of(curve)
            for name, value in features._asdict().items():
                row[name] = value
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


def _smallest(values: NDArray[Any]) -> NDArray[Any]:
    """Return values in the smallest type of whole numbers that holds them."""
    return values.astype(np.int16 if values.max(initial=0) <= np.iinfo(np.int16).max else np.int32)
