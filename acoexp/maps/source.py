"""What a map source is: a few parameters, and a grid to be had for them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar

from acoexp.grid.grid import Grid


class MapSource(ABC):
    """One way to get a map; subclasses are frozen dataclasses whose fields are their parameters.

    Attributes:
        numbered: The whole-number parameter that tells its maps apart, such as a seed; None for a source of one
            map.
    """

    numbered: ClassVar[str | None] = None

    @abstractmethod
    def load(self) -> Grid:
        """Return the grid.

        Raises:
            MapError: if it cannot be read, or no path can be planned on it.
        """
