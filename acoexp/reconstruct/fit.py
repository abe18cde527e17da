"""The fit of a map, as it is written down with it: what fresh trials came to, beside the published ten."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.moves import path_length
from acoexp.reconstruct.likelihood import matches, score
from acoexp.reconstruct.outcomes import Outcomes
from acoexp.reconstruct.published import Environment


@dataclass(frozen=True)
class Fit:
    """What trials came to.

    Attributes:
        trials: How many there were.
        l1, l2: How many have each of the published lengths, by length to four decimals.
        x1, x3: Means.
        score: See :func:`~acoexp.reconstruct.likelihood.score`.
    """

    trials: int
    l1: dict[str, int]
    l2: dict[str, int]
    x1: float
    x3: float
    score: float

    @classmethod
    def of(cls, environment: Environment, outcomes: Outcomes) -> Fit:
        """Return the fit of some trials."""
        return cls(
            trials=outcomes.size,
            l1=_counted(environment, outcomes.l1),
            l2=_counted(environment, outcomes.l2),
            x1=float(outcomes.x1.mean()),
            x3=float(outcomes.x3.mean()),
            score=score(environment, outcomes),
        )

    def in_words(self, environment: Environment) -> str:
        """Return one line for readers, with what is published in brackets."""
        if not environment.has_trials:
            found, converged = (next(iter(counts.values())) / self.trials for counts in (self.l1, self.l2))
            return (
                f"standard ACO, {self.trials} fresh trials: {found:.0%} find the optimum, {converged:.0%} "
                f"converge to it, mean x1 {self.x1:.1f}, x3 {self.x3:.1f}; no trial of standard ACO is published"
            )
        published = Fit.of(environment, environment.trials)
        parts = [
            f"{count / self.trials:.0%} {verb} {length} ({known[length]} of 10)"
            for verb, counts, known in (("find", self.l1, published.l1), ("converge to", self.l2, published.l2))
            for length, count in counts.items()
            if known[length]
        ]
        parts.append(f"mean x1 {self.x1:.1f} ({published.x1:.1f}), x3 {self.x3:.1f} ({published.x3:.1f})")
        return f"standard ACO, {self.trials} fresh trials (in brackets: published): " + ", ".join(parts)


def _counted(environment: Environment, lengths: NDArray[np.float64]) -> dict[str, int]:
    wanted = np.array([path_length(*pair) for pair in (environment.optimum, *environment.local_optima)])
    counts = matches(wanted, lengths).sum(axis=1).tolist()
    return {f"{length:.4f}": count for length, count in zip(wanted, counts, strict=True)}
