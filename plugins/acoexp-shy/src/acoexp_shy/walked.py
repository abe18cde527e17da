"""The edge that an ant has just walked."""

from __future__ import annotations

from typing import Any

from acoexp.colony.compiled import compiled


@compiled
def edge_behind(colony: Any, cell: Any, came: Any) -> Any:
    """Return the edge by which an ant arrived at ``cell`` in direction ``came``."""
    return (cell - colony.offsets[came]) * 8 + came
