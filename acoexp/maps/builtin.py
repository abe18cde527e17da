"""The maps of Liu et al. 2017, reconstructed: the figures are lost, the optima are published.

Each file under ``data/`` says in its first lines how it was found and under which rule for diagonals.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib.resources import files
from typing import ClassVar

from acoexp.grid.grid import Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.maps.source import MapSource
from acoexp.maps.text import parse_map
from acoexp.parameters import parameter


@dataclass(frozen=True, kw_only=True)
class BuiltinMap(MapSource):
    """A map that comes with the package."""

    name: ClassVar[str]

    moves: str | None = parameter(None, "rule for diagonals, if not the one the map declares", choices=MOVE_RULES)

    def load(self) -> Grid:
        """Read the map from the package's data."""
        text = files("acoexp.maps").joinpath("data", f"{self.name}.txt").read_text(encoding="utf-8")
        return parse_map(text, name=self.name, moves=self.moves)


class Fig13(BuiltinMap):
    """20 x 20, optimum 30.3848: the paper's own environment (Figs 13-16, Table 1), a reconstruction."""

    name = "fig13"


class Env1(BuiltinMap):
    """20 x 20, optimum 32.1421: environment 1 of Luo and Wu 2010 (Table 3), a reconstruction."""

    name = "env1"


class Env2(BuiltinMap):
    """20 x 20, optimum 35.0711: environment 2 of Luo and Wu 2010 (Tables 2, 3; Figs 17, 18), a reconstruction."""

    name = "env2"
