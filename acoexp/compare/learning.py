"""What a colony learns: how good its paths are in the first cycle, without pheromone, and in the end.

Where paths are optimised afterwards a good result need not be the colony's: an ant that walked at random may
do, once its path is straightened. So each such configuration is run with ``alpha = 0``, too.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from acoexp.compare.configuration import Configuration
from acoexp.compare.sample import Row, Sample
from acoexp.compare.statistics import Values


def optimises(configuration: Configuration) -> bool:
    """Tell whether paths are optimised after ants have walked them."""
    return configuration.settings.parts["post"].kernel is not None


def without_learning(configuration: Configuration) -> Configuration:
    """Return the same configuration with ``alpha = 0``: its ants never see pheromone."""
    settings = configuration.settings
    blind = replace(settings, scalars=replace(settings.scalars, alpha=0.0))
    return configuration._replace(label=f"{configuration.label}, alpha = 0", settings=blind)


def learning_row(sample: Sample, blind: Sample) -> Row:
    """Return the mean gaps to the exact optimum, as shares of it, and how many trials arrived.

    Args:
        sample: Trials of a configuration.
        blind: Those of the same, with alpha = 0.
    """
    lengths = {"first": sample.curves[:, 0], "blind": blind.features["l1"], "learned": sample.features["l1"]}
    row: Row = {"map": sample.map, "cell": sample.configuration, "trials": sample.found.size}
    for name, values in lengths.items():
        row |= {name: _gap(values, sample.optimum), f"{name}_arrived": int(np.isfinite(values).sum())}
    return row


def _gap(lengths: Values, optimum: float) -> float:
    arrived = lengths[np.isfinite(lengths)]
    return float(arrived.mean() / optimum - 1.0) if arrived.size else float("nan")
