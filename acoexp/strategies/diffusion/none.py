"""No diffusion: pheromone stays where the ants laid it (standard ACO)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from acoexp.colony.compiled import compiled
from acoexp.strategies.part import Diffusion


@compiled
def stay(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Do nothing."""


@dataclass(frozen=True, kw_only=True)
class NoDiffusion(Diffusion):
    """Leaves pheromone where it is."""

    kernel = staticmethod(stay)
