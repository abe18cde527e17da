"""acoexp: experiments with ant-colony path planning of mobile robots on occupancy grids.

>>> import acoexp
>>> acoexp.solve("env2", algo="pdg", seed=0).length
35.071...
"""

from acoexp.api import solve, solve_many
from acoexp.errors import AcoexpError, MapError, SettingsError, StrategyError, TrackingError
from acoexp.grid.grid import Grid
from acoexp.registry.load_map import load_map
from acoexp.trial.result import Result

__all__ = [
    "AcoexpError",
    "Grid",
    "MapError",
    "Result",
    "SettingsError",
    "StrategyError",
    "TrackingError",
    "load_map",
    "solve",
    "solve_many",
]
