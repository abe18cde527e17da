"""acoexp: experiments with ant-colony path planning of mobile robots on occupancy grids.

>>> import acoexp
>>> acoexp.solve("env2", algo="pdg", seed=0).length
35.071...
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from acoexp.api import solve, solve_many
    from acoexp.errors import AcoexpError, MapError, SettingsError, StrategyError, TrackingError
    from acoexp.grid.grid import Grid
    from acoexp.registry.load_map import load_map
    from acoexp.trial.result import Result
    from acoexp.watch.recording import Recording, record

__all__ = [
    "AcoexpError",
    "Grid",
    "MapError",
    "Recording",
    "Result",
    "SettingsError",
    "StrategyError",
    "TrackingError",
    "load_map",
    "record",
    "solve",
    "solve_many",
]

_HOMES = {
    "solve": "api",
    "solve_many": "api",
    "Grid": "grid.grid",
    "Result": "trial.result",
    "load_map": "registry.load_map",
    "Recording": "watch.recording",
    "record": "watch.recording",
}


def __getattr__(name: str) -> Any:
    """Import what is asked for, and nothing before: the command tells of Ctrl-C from its first moment on."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    found = getattr(import_module(f"{__name__}.{_HOMES.get(name, 'errors')}"), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
