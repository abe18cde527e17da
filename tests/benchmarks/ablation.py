"""How ``nav`` fares on real maps with each of its parts left out or replaced, once."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from nav import of_maps
from rows import Given, Row

ABLATION: dict[str, dict[str, Any]] = {
    "nav": {},
    "no shortcut": {"post": "geometric"},
    "paths as walked": {"post": "none"},
    "straight line": {"heuristic": "progress"},
    "exact distance": {"heuristic": "geodesic"},
    "ants are lost": {"dead_end": "lost"},
    "every ant lays": {"update": "ant_cycle"},
    "with diffusion": {"diffusion": "gaussian"},
    "no learning": {"alpha": 0.0},
    "one cycle": {"iterations": 1},
}
"""Settings beside the preset's, by what is left out or put in its place."""


def rows(given: Given) -> Iterator[Row | str]:
    """Yield nav as it is, then each change of it."""
    yield from of_maps(given, {name: ("nav", settings) for name, settings in ABLATION.items()})
