"""The artificial potential field of a map (Liu et al. 2017, Eqs 1-5): where its force pulls a robot.

The goal attracts, obstacles repel. Everything is in cells: distances between cell centres, x to the right,
y upwards. The map's outer border is not an obstacle.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.parameters import parameter

_ROUNDING = 1e-12
"""Forces that cancel leave this share of themselves; its direction would be made of rounding."""

NO_DIRECTION = 8
"""Sector of a cell on which no force acts."""


@dataclass(frozen=True, kw_only=True)
class FieldSettings:
    """The constants of Eqs 2 and 3; the paper does not give them."""

    attraction: float = parameter(
        1.0, "gain K_a of the goal's pull, per cell of distance (Eq. 2)", minimum=0.0, maximum=1e6
    )
    repulsion: float = parameter(25.0, "gain K_r of the obstacles' push (Eq. 3)", minimum=0.0, maximum=1e6)
    reach: float = parameter(4.0, "distance rho_0 in cells beyond which obstacles do not push", above=0.0)
    obstacles: str = parameter(
        "sum",
        "obstacle cells that push: all in reach (Eq. 4), or the nearest alone (Eq. 3)",
        choices=("sum", "nearest"),
    )


@dataclass(frozen=True, eq=False)
class PotentialField:
    """The resultant force on every cell and the sector it points into.

    Attributes:
        force: float[rows, cols, 2], the resultant (x, y) of Eq. 4; zero on obstacles.
        sector: uint8[rows, cols], direction 0..7 of the force (Eq. 5), or ``NO_DIRECTION``.
    """

    force: NDArray[np.float64]
    sector: NDArray[np.uint8]


def potential_field(
    obstacles: NDArray[np.bool_], goal: tuple[int, int], settings: FieldSettings
) -> PotentialField:
    """Compute the field of a map, once for all trials on it.

    Args:
        obstacles: bool[rows, cols], True where a robot cannot be.
        goal: The cell that attracts, (row, column).
        settings: The constants.
    """
    pull = _attraction(obstacles.shape, goal, settings.attraction)
    push, gross = _repulsion(obstacles, settings)
    force = pull + push
    gross += np.hypot(pull[..., 0], pull[..., 1])
    cancels = np.hypot(force[..., 0], force[..., 1]) <= _ROUNDING * gross
    force[cancels | obstacles] = 0.0
    return PotentialField(force, sectors(force))


def sectors(force: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return the sector of each force, float[..., 2] -> uint8[...].

    Eq. 5 as printed is off by half a sector; with the sectors as the paper defines them just above it, it
    reads floor(theta / (pi / 4) + 1/2) mod 8, 0-based.
    """
    theta = np.arctan2(force[..., 1], force[..., 0])
    sector = np.floor(theta / (np.pi / 4) + 0.5).astype(np.int64) % 8
    return np.where((force == 0.0).all(axis=-1), NO_DIRECTION, sector).astype(np.uint8)


def _attraction(shape: tuple[int, ...], goal: tuple[int, int], gain: float) -> NDArray[np.float64]:
    """Return the pull of the goal, -grad U_att of Eq. 2: proportional to the distance."""
    row, col = np.indices(shape)
    return gain * np.stack([goal[1] - col, row - goal[0]], axis=-1).astype(np.float64)


def _repulsion(
    obstacles: NDArray[np.bool_], settings: FieldSettings
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the push of the obstacle cells in reach, -grad U_rep of Eq. 3 (its cases in the right order).

    And what the pushes' strengths add up to, whatever their directions. Of all in reach it is the sum; of the
    nearest, where several are equally near, the mean.
    """
    force, gross = np.zeros((*obstacles.shape, 2)), np.zeros(obstacles.shape)
    nearest_only = settings.obstacles == "nearest"
    nearest = _nearest(obstacles, settings.reach) if nearest_only else np.empty(0)
    count = np.zeros(obstacles.shape)
    for down, right, hits in _in_reach(obstacles, settings.reach):
        if nearest_only:
            hits = hits & (nearest == down**2 + right**2)
        distance = float(np.hypot(down, right))
        strength = settings.repulsion * (1.0 / distance - 1.0 / settings.reach) / distance**2
        force[hits] += strength * np.array([-right, down]) / distance
        gross[hits] += strength
        count[hits] += 1.0
    if nearest_only:
        share = 1.0 / np.maximum(count, 1.0)
        return force * share[..., None], gross * share
    return force, gross


def _nearest(obstacles: NDArray[np.bool_], reach: float) -> NDArray[np.float64]:
    """Return the squared distance from each cell to the nearest obstacle in reach, inf where there is none."""
    nearest = np.full(obstacles.shape, np.inf)
    for down, right, hits in _in_reach(obstacles, reach):
        nearest[hits] = np.minimum(nearest[hits], down**2 + right**2)
    return nearest


def _in_reach(obstacles: NDArray[np.bool_], reach: float) -> Iterator[tuple[int, int, NDArray[np.bool_]]]:
    """Yield, for each way (down, right) to a cell in reach, the cells from which it leads to an obstacle."""
    rows, cols = obstacles.shape
    margin = min(int(reach), max(rows, cols))
    around = np.pad(obstacles, margin)
    for down in range(-margin, margin + 1):
        for right in range(-margin, margin + 1):
            if 0.0 < np.hypot(down, right) <= reach:
                yield down, right, around[margin + down :, margin + right :][:rows, :cols]
