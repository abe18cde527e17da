"""Packing: recordings as the page takes them, a few bits for each cell and move, deflated.

Pheromone is one byte for each cell and cycle, on a logarithmic scale of the cycle's own, from its weakest to its
strongest. Cells that are as most cells in all cycles take no room, of the others there is the difference to the
cycle before. A way is the turns that it takes, in eighths of a circle.
"""

from __future__ import annotations

import zlib
from base64 import b64encode
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.field import potential_field
from acoexp.grid.grid import Grid
from acoexp.trial.features import without_nan
from acoexp.watch.cycles import Cycles, Way

WIDEST = 1e3
"""How much stronger the strongest pheromone may be than what has the colour of the weakest."""

NARROWEST = 3.0
"""How much stronger it must be to have the colour of the strongest: the first cycles make small differences."""

WIDEST_FORCE = 1e6
"""``WIDEST`` for the strength of forces."""

SMALL = 64
"""Cells on a side of a map that is shown whole."""

MOST_ANTS = 60
"""Ants of a cycle that are shown; more could not be told apart."""

NOWHERE = 8
"""The direction of what has none."""

_GONE = float(np.finfo(np.float32).tiny)


class Packed(NamedTuple):
    """A recording, packed.

    Attributes:
        grid: The map.
        cycles: How many cycles it has.
        seen: Cells that there is something to be seen on, bool[rows, cols].
        colony: The rest, as plain values for JSON.
    """

    grid: Grid
    cycles: int
    seen: NDArray[np.bool_]
    colony: dict[str, Any]


def packed(name: str, recording: Cycles) -> Packed:
    """Return a recording, packed, under a name for it."""
    scales, levels = _pheromone(recording)
    common, grid, result = _common(levels), recording.grid, recording.result
    touched = np.flatnonzero((levels != common[:, None]).any(axis=0))
    frames = levels[:, touched]
    frames[1:] -= levels[:-1, touched]
    field = potential_field(grid.obstacles, grid.goal, recording.settings.field)
    strength = np.hypot(field.force[..., 0], field.force[..., 1])
    force_scale = Scale.of(strength, WIDEST_FORCE)
    colony = {
        "name": name,
        "seed": str(result.seed),  # JavaScript would round it
        "cycles": recording.cycles,
        "ants": recording.settings.scalars.ants,
        "lost": result.lost_ants.tolist(),
        "curve": result.curve.tolist(),
        "bests": [{"cycle": b.cycle, "length": b.length, "turns": _digits(b.moves)} for b in recording.bests],
        "scales": scales,
        "common": _deflated(common),
        "touched": _deflated(np.diff(touched, prepend=0).astype("<u4")),
        "frames": _deflated(frames),
        "forceScale": force_scale,
        "force": _deflated(force_scale.bytes_of(strength)),
        "forceAngle": _deflated(_angles(field.force)),
        "heuristic": _deflated(_preferred(recording.desirability)),
        **_ways(recording),
    }
    seen = np.asarray((levels > common[:, None]).any(axis=0)).reshape(grid.shape)
    return Packed(grid, recording.cycles, seen, without_nan(colony))


def packed_map(colonies: Sequence[Packed]) -> dict[str, Any]:
    """Return the map of packed recordings, as plain values for JSON."""
    grid = colonies[0].grid
    frame = grid.frame
    return {
        "name": grid.name,
        "rows": grid.shape[0],
        "cols": grid.shape[1],
        "start": grid.start,
        "goal": grid.goal,
        "moves": grid.moves,
        "optimum": grid.optimum,
        "obstacles": _deflated(grid.obstacles),
        "frame": None if frame is None else [frame.resolution, *frame.origin, frame.yaw],
        "window": _window(grid, np.logical_or.reduce([one.seen for one in colonies])),
    }


class Scale(NamedTuple):
    """A logarithmic scale: what the bytes 0 and 255 stand for."""

    low: float
    high: float

    @classmethod
    def of(cls, values: NDArray[Any], widest: float, narrowest: float = 1.0) -> Scale:
        """Return the scale of some values, those that are 0 left out."""
        positive = values[values > 0.0]
        if not positive.size:
            return cls(1.0, 1.0)
        low, high = float(positive.min()), float(positive.max())
        low = max(low, high / widest)
        return cls(low, max(high, low * narrowest))

    def bytes_of(self, values: NDArray[Any]) -> NDArray[np.uint8]:
        """Return where values are on the scale; 0 for those below it."""
        span = np.log(self.high / self.low) or 1.0
        place = np.log(np.maximum(values, self.low) / self.low) / span
        bytes_: NDArray[np.uint8] = np.rint(255.0 * np.minimum(place, 1.0)).astype(np.uint8)
        return bytes_


def _pheromone(recording: Cycles) -> tuple[list[Scale], NDArray[np.uint8]]:
    """Return the scale of each cycle, one before the first included, and the bytes, uint8[cycles + 1, cells]."""
    scales, levels = [], []
    led_to = recording.grid.allowed.ravel() > 0  # a way that can be gone can be come
    for row in recording.pheromone:
        finite = np.nan_to_num(row.ravel()).astype(np.float64)
        # what has all but gone is the weakest that there is, and no reason to leave it out
        scales.append(Scale.of(finite[led_to].clip(min=_GONE), WIDEST, NARROWEST))
        levels.append(scales[-1].bytes_of(finite))
    return scales, np.stack(levels)


def _window(grid: Grid, seen: NDArray[np.bool_]) -> list[int]:
    """Return what is shown of a map, [top, left, bottom, right]: of a large one where ants were, and a margin."""
    rows, cols = grid.shape
    if max(rows, cols) <= SMALL:
        return [0, 0, rows, cols]
    seen[grid.start] = seen[grid.goal] = True
    row, col = np.nonzero(seen)
    margin = max(rows, cols) // 40
    low = np.maximum([row.min() - margin, col.min() - margin], 0)
    high = np.minimum([row.max() + margin + 1, col.max() + margin + 1], grid.shape)
    return [int(number) for number in (*low, *high)]


def _common(levels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return what most cells have in each cycle, uint8[cycles + 1]."""
    return np.array([np.bincount(row, minlength=256).argmax() for row in levels], dtype=np.uint8)


def _shown_ants(recording: Cycles) -> list[list[int]]:
    """Return the ants of each cycle that are shown: some of many, evenly chosen, the cycle's best among them."""
    ants = recording.settings.scalars.ants
    some = np.unique(np.linspace(0, ants - 1, min(ants, MOST_ANTS)).round().astype(int)).tolist()
    return [some if best < 0 or best in some else [best, *some[1:]] for best in recording.winners.tolist()]


def _ways(recording: Cycles) -> dict[str, Any]:
    shown, winners, turns, steps, lost, best = _shown_ants(recording), recording.winners.tolist(), [], [], [], []
    for cycle, (ants, winner) in enumerate(zip(shown, winners, strict=True), 1):
        ways: list[Way] = recording.ways(cycle)
        for ant in ants:
            moves = ways[ant].moves
            turns.append(_turns(moves))
            steps.append(moves.size)
            lost.append(ways[ant].lost)
        best.append(ants.index(winner) if winner >= 0 else 255)
    return {
        "shown": len(shown[0]),
        "turns": _deflated(np.concatenate(turns)),
        "steps": _deflated(np.array(steps, dtype="<u4")),
        "stuck": _deflated(np.array(lost, dtype=np.uint8)),
        "winners": _deflated(np.array(best, dtype=np.uint8)),
    }


def _angles(force: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return the direction of each force in 256ths of a circle, counterclockwise from the right."""
    turns = np.arctan2(force[..., 1], force[..., 0]) / (2.0 * np.pi)
    return (np.rint(256.0 * turns).astype(np.int64) % 256).astype(np.uint8)


def _preferred(desirability: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return the direction that the heuristic likes best in each cell; ``NOWHERE`` where no move is allowed."""
    best = desirability.argmax(axis=-1).astype(np.uint8)
    return np.where(desirability.max(axis=-1) > 0.0, best, np.uint8(NOWHERE))


def _digits(moves: NDArray[np.uint8]) -> str:
    return (_turns(moves) + ord("0")).tobytes().decode("ascii")


def _turns(moves: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return (np.diff(moves, prepend=np.uint8(0)) & 7).astype(np.uint8)


def _deflated(values: NDArray[Any]) -> str:
    return b64encode(zlib.compress(np.ascontiguousarray(values).tobytes(), 9)).decode("ascii")
