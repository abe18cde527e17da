"""Eq. 18 with the paths as walked, then Eq. 19 with the optimised ones, each with its own evaporation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from acoexp.colony.compiled import compiled
from acoexp.strategies.part import Update
from acoexp.strategies.update.ant_cycle import evaporate_and_lay


@compiled
def update(colony: Any, own: Any, raw: Any, final: Any, best: Any) -> None:
    """Update with the paths as walked, then once more with the optimised ones."""
    evaporate_and_lay(colony, raw)
    evaporate_and_lay(colony, final)


@dataclass(frozen=True, kw_only=True)
class DualAntCycle(Update):
    """Updates twice a cycle: with the paths as walked, then with the optimised ones (Eqs 18, 19)."""

    kernel = staticmethod(update)
