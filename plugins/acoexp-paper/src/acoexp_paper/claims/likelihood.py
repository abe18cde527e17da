"""How well each map meets the rows of standard ACO that it was fitted to, and what it weighs by that."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from acoexp.compare.statistics import Values
from acoexp.grid.grid import Grid
from acoexp.reconstruct.likelihood import log_likelihood
from acoexp.reconstruct.published import ENVIRONMENTS

_LEAST = 1e-9
"""Of the best map's weight, so that no single map is all there is."""


def scores(maps: Sequence[Grid]) -> Values:
    """Return the log-likelihood of the published rows of standard ACO under each map, float[maps]; nan if unknown.

    It is the one that :mod:`acoexp.reconstruct` left with the map, of fresh trials.
    """
    return np.array([float(grid.metadata.get("score", np.nan)) for grid in maps])


def of_themselves(env: str) -> float:
    """Return the log-likelihood of an environment's published rows as if they were the simulated ones.

    It tells what their spread and the estimate's smoothing leave, and is no bound.
    """
    published = ENVIRONMENTS[env].trials
    return log_likelihood(published, published)


def weights(maps: Sequence[Grid]) -> Values | None:
    """Return the maps' likelihoods, float[maps], which sum up to 1; None if one is unknown or there is one map."""
    logarithms = scores(maps)
    if len(maps) < 2 or np.isnan(logarithms).any():
        return None
    likelihoods: Values = np.maximum(np.exp(logarithms - logarithms.max()), _LEAST)
    return np.asarray(likelihoods / likelihoods.sum())
