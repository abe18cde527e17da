"""What a map source is: a few parameters, and a grid to be had for them."""

from __future__ import annotations

from abc import ABC, abstractmethod

from acoexp.grid.grid import Grid


class MapSource(ABC):
    """One way to get a map; subclasses are frozen dataclasses whose fields are their parameters."""

    @abstractmethod
    def load(self) -> Grid:
        """Return the grid.

        Raises:
            MapError: if it cannot be read, or no path can be planned on it.
        """
