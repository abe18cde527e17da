"""The artificial potential field of a map (Liu et al. 2017, Eqs 1-5): where its force pulls a robot.

The goal attracts, obstacles repel. Everything is in cells: distances between cell centres, x to the right,
y upwards. The map's outer border is not an obstacle.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.parameters import parameter

_ROUNDING = 1e-12
"""Forces that cancel leave this share of themselves; its direction would be made of rounding."""

_STRIP = 2**15
"""Cells whose forces are added up at a time: as many as the processor keeps at hand."""

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
    rows, cols = obstacles.shape
    margin = min(int(settings.reach), max(rows, cols))
    around, pushes = np.pad(obstacles, margin), _pushes(settings, margin)
    field = PotentialField(np.empty((rows, cols, 2)), np.empty((rows, cols), dtype=np.uint8))
    height = max(1, _STRIP // cols)
    for top in range(0, rows, height):
        strip = slice(top, min(top + height, rows))
        push, gross = _repulsion(around[top : strip.stop + 2 * margin], margin, pushes, settings)
        pull = _attraction(strip, cols, goal, settings.attraction)
        force = field.force[strip]
        force[..., 0], force[..., 1] = pull[0] + push[0], pull[1] + push[1]
        gross += np.hypot(*pull)
        cancels = np.hypot(force[..., 0], force[..., 1]) <= _ROUNDING * gross
        force[cancels | obstacles[strip]] = 0.0
        field.sector[strip] = sectors(force)
    return field


def sectors(force: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return the sector of each force, float[..., 2] -> uint8[...].

    Eq. 5 as printed is off by half a sector; with the sectors as the paper defines them just above it, it
    reads floor(theta / (pi / 4) + 1/2) mod 8, 0-based.
    """
    theta = np.arctan2(force[..., 1], force[..., 0])
    sector = np.floor(theta / (np.pi / 4) + 0.5).astype(np.int64) % 8
    return np.where((force == 0.0).all(axis=-1), NO_DIRECTION, sector).astype(np.uint8)


def _attraction(
    rows: slice, cols: int, goal: tuple[int, int], gain: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the pull of the goal on some rows, -grad U_att of Eq. 2: proportional to the distance.

    As its two parts, (x, y): float[1, cols] and float[rows, 1], as x is the same in all rows.
    """
    row, col = np.ogrid[rows, :cols]
    return gain * (goal[1] - col).astype(np.float64), gain * (row - goal[0]).astype(np.float64)


class _Push(NamedTuple):
    """What an obstacle does to the cell from which a way (down, right) leads to it."""

    down: int
    right: int
    strength: float
    x: float
    y: float


def _pushes(settings: FieldSettings, margin: int) -> list[_Push]:
    """Return the push along each way in reach, -grad U_rep of Eq. 3 (its cases in the right order).

    Row by row, or the nearest first where only they count; floats are added up in this order.
    """
    pushes = []
    for down in range(-margin, margin + 1):
        for right in range(-margin, margin + 1):
            distance = float(np.hypot(down, right))
            if 0.0 < distance <= settings.reach:
                strength = settings.repulsion * (1.0 / distance - 1.0 / settings.reach) / distance**2
                parts = (strength * part / distance for part in (-right, down))
                pushes.append(_Push(down, right, strength, *parts))
    if settings.obstacles == "nearest":
        pushes.sort(key=lambda push: push.down**2 + push.right**2)
    return pushes


def _repulsion(
    around: NDArray[np.bool_], margin: int, pushes: list[_Push], settings: FieldSettings
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the push of the obstacle cells in reach of a strip, float[2, rows, cols] as (x, y).

    And what the pushes' strengths add up to, whatever their directions. Of all in reach it is the sum; of the
    nearest, where several are equally near, the mean.

    Args:
        around: bool[rows + 2 margin, cols + 2 margin], the strip's obstacles, and those around it.
        margin: How far it reaches beyond the strip on each side.
        pushes: What to add up, in this order.
        settings: The constants.
    """
    rows, cols = (size - 2 * margin for size in around.shape)
    nearest = np.full((rows, cols), np.inf) if settings.obstacles == "nearest" else None
    total, part = np.zeros((3 if nearest is None else 4, rows, cols)), np.empty((rows, cols))
    there = around.astype(np.float64)
    for push in pushes:
        hits = there[margin + push.down :, margin + push.right :][:rows, :cols]
        if nearest is not None:
            squared = push.down**2 + push.right**2
            hits = hits * (nearest >= squared)
            nearest[hits > 0.0] = squared
        for sum_, value in zip(total, (push.x, push.y, push.strength, 1.0), strict=False):
            if value != 0.0:
                sum_ += np.multiply(hits, value, out=part)
    if nearest is not None:
        total[:3] *= 1.0 / np.maximum(total[3], 1.0)
    return total[:2], total[2]
