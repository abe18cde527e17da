"""Trials: what many trials of one configuration found, as columns; as batches are kept and compared."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.trial.features import best_so_far, curve_of, features_of, prolonged
from acoexp.trial.quality import Quality
from acoexp.trial.result import Result
from acoexp.trial.table import TABLE

_COLUMNS = ("seeds", "curve_pairs", "lost_ants", "cycle_steps", "cycles", "quality")


@dataclass(frozen=True, eq=False)
class Trials:
    """Trials of one configuration, in the order of their seeds.

    Attributes:
        seeds: uint64[n].
        curve_pairs: int[n, longest, 2], (straight, diagonal) moves of the best path found in each cycle; -1
            where all ants were lost. A trial of fewer cycles stays as it was in its last one, which changes none
            of its features.
        lost_ants: int[n, longest], ants lost in each cycle; 0 after the last.
        cycle_steps: int[n, longest], moves made by all ants together in each cycle; 0 after the last.
        cycles: int32[n], cycles that were run.
        quality: float64[n, 5], that of each path, in the order of :class:`~acoexp.trial.quality.Quality`.
    """

    seeds: NDArray[np.uint64]
    curve_pairs: NDArray[Any]
    lost_ants: NDArray[Any]
    cycle_steps: NDArray[Any]
    cycles: NDArray[np.int32]
    quality: NDArray[np.float64]

    @classmethod
    def of(cls, results: Sequence[Result]) -> Trials:
        """Return what one or more results leave behind."""
        ordered = sorted(results, key=lambda result: result.seed)
        longest = max(result.cycles for result in ordered)
        return cls(
            seeds=np.array([r.seed for r in ordered], dtype=np.uint64),
            curve_pairs=_smallest(np.array([prolonged(r.curve_pairs, longest) for r in ordered])),
            lost_ants=_smallest(np.array([np.pad(r.lost_ants, (0, longest - r.cycles)) for r in ordered])),
            cycle_steps=_smallest(np.array([np.pad(r.cycle_steps, (0, longest - r.cycles)) for r in ordered])),
            cycles=np.array([r.cycles for r in ordered], dtype=np.int32),
            quality=np.array([r.quality for r in ordered], dtype=np.float64),
        )

    @classmethod
    def joined(cls, parts: Iterable[Trials]) -> Trials:
        """Return the trials of all parts, one or more; of several with one seed the first."""
        given = list(parts)
        seeds, place = np.unique(np.concatenate([p.seeds for p in given]), return_index=True)
        longest = max(part.curve_pairs.shape[1] for part in given)
        given = [part.prolonged(longest) for part in given]
        columns = [np.concatenate([getattr(p, name) for p in given])[place] for name in _COLUMNS[1:]]
        return cls(seeds, *columns)

    def prolonged(self, cycles: int) -> Trials:
        """Return them as of trials that were at least so many cycles long."""
        more = cycles - self.curve_pairs.shape[1]
        if more <= 0:
            return self
        counts = {name: np.pad(getattr(self, name), ((0, 0), (0, more))) for name in ("lost_ants", "cycle_steps")}
        return replace(self, curve_pairs=prolonged(self.curve_pairs, cycles), **counts)

    def among(self, seeds: NDArray[np.uint64]) -> Trials:
        """Return those whose seeds are among these."""
        wanted = np.isin(self.seeds, seeds)
        return Trials(*(getattr(self, name)[wanted] for name in _COLUMNS))

    def __len__(self) -> int:
        return int(self.seeds.size)

    @cached_property
    def curves(self) -> NDArray[np.float64]:
        """Best length found in each cycle, float[n, longest]; nan where all ants were lost."""
        return curve_of(self.curve_pairs)

    @property
    def best_pairs(self) -> NDArray[Any]:
        """(straight, diagonal) moves of the best path found up to each cycle, int[n, longest, 2]; -1 before it."""
        found = np.where(self.curves == best_so_far(self.curves), np.arange(self.curves.shape[1]), 0)
        latest = np.maximum.accumulate(found, axis=1)
        return np.take_along_axis(self.curve_pairs, latest[:, :, None], axis=1)

    @cached_property
    def table(self) -> NDArray[np.void]:
        """The features, one row for each trial, of type ``TABLE``."""
        table = np.zeros(len(self), dtype=TABLE)
        table["seed"], table["ant_steps"] = self.seeds, self.cycle_steps.sum(axis=1, dtype=np.int64)
        table["lost_ants"], table["cycles"] = self.lost_ants.sum(axis=1), self.cycles
        for name, column in zip(Quality._fields, self.quality.T, strict=True):
            table[name] = column
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
    largest = values.max(initial=0)
    kinds = (np.int16, np.int32, np.int64)
    return values.astype(next(kind for kind in kinds if largest <= np.iinfo(kind).max))
