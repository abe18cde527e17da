"""``map=random``: each cell is an obstacle or not, by chance alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from acoexp.maps.generated import GeneratedMap
from acoexp.parameters import parameter


@dataclass(frozen=True, kw_only=True)
class RandomMap(GeneratedMap):
    """Obstacle cells at random, a share of all, drawn from a seed until there is a way."""

    kind = "random"

    density: float = parameter(0.2, "share of cells that are obstacles, on average", minimum=0.0, maximum=1.0)

    def obstacles(self, rng: Generator) -> NDArray[np.bool_]:
        """Draw a number for each cell."""
        return rng.random(self.size) < self.density

    def label(self) -> str:
        """Return the density."""
        return f"d{self.density:g}"
