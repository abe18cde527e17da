"""Packing: recordings as the page takes them, a few bits for each cell and move, deflated.

Pheromone is one byte for each cell and cycle, on a scale of ``DECADES`` powers of ten below the strongest of that
cycle: 255 is the strongest, 0 what is below the scale. Cells that are as most cells in all cycles take no room, of
the others there is the difference to the cycle before. A way is the turns that it takes, in eighths of a circle.
"""

from __future__ import annotations

import zlib
from base64 import b64encode
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.field import potential_field
from acoexp.trial.features import without_nan
from acoexp.watch.recording import Recording, Way

DECADES = 3
"""Powers of ten that the colours of pheromone span."""

FORCE_DECADES = 6
"""Those that the strength of forces spans."""

MOST_ANTS = 60
"""Ants of a cycle that are shown; more could not be told apart."""

NOWHERE = 8
"""The direction of what has none."""


def packed(recordings: Mapping[str, Recording]) -> dict[str, Any]:
    """Return recordings of trials on one map, by what they are called, as plain values for JSON."""
    grid = next(iter(recordings.values())).grid
    levels = {name: _bytes_of_pheromone(recording) for name, recording in recordings.items()}
    frame = grid.frame
    return {
        "decades": DECADES,
        "forceDecades": FORCE_DECADES,
        "map": {
            "name": grid.name,
            "rows": grid.shape[0],
            "cols": grid.shape[1],
            "start": grid.start,
            "goal": grid.goal,
            "moves": grid.moves,
            "optimum": grid.optimum,
            "obstacles": _deflated(grid.obstacles),
            "frame": None if frame is None else [frame.resolution, *frame.origin, frame.yaw],
            "window": _window(recordings, levels),
        },
        "colonies": [_colony(name, recordings[name], levels[name]) for name in recordings],
    }


def _colony(name: str, recording: Recording, levels: NDArray[np.uint8]) -> dict[str, Any]:
    result, shown = recording.result, _shown_ants(recording)
    common = np.array([np.bincount(row, minlength=256).argmax() for row in levels], dtype=np.uint8)
    touched = np.flatnonzero((levels != common[:, None]).any(axis=0))
    frames = levels[:, touched]
    frames[1:] -= levels[:-1, touched]
    field = potential_field(recording.grid.obstacles, recording.grid.goal, recording.settings.field)
    strength = np.hypot(field.force[..., 0], field.force[..., 1])
    plain = {
        "name": name,
        "seed": result.seed,
        "cycles": recording.cycles,
        "ants": recording.settings.scalars.ants,
        "lost": result.lost_ants.tolist(),
        "curve": result.curve.tolist(),
        "bests": [{"cycle": b.cycle, "length": b.length, "moves": _digits(b.moves)} for b in recording.bests],
        "strongest": [float(row.max()) for row in _finite(recording)],
        "common": _deflated(common),
        "touched": _deflated(np.diff(touched, prepend=0).astype("<u4")),
        "frames": _deflated(frames),
        "forceStrongest": float(strength.max()),
        "force": _deflated(in_decades(strength, FORCE_DECADES)),
        "forceAngle": _deflated(_angles(field.force)),
        "heuristic": _deflated(_preferred(recording.desirability)),
        **_packed_ways(recording, shown),
    }
    done: dict[str, Any] = without_nan(plain)
    return done


def in_decades(values: NDArray[Any], decades: int) -> NDArray[np.uint8]:
    """Return values, at least 0, as bytes on a logarithmic scale: 255 the highest, 0 what is below the scale."""
    with np.errstate(divide="ignore", invalid="ignore"):
        place = 1.0 + np.log10(values / values.max()) / decades
    return np.rint(255.0 * np.clip(np.nan_to_num(place, nan=0.0, neginf=0.0), 0.0, 1.0)).astype(np.uint8)


def _bytes_of_pheromone(recording: Recording) -> NDArray[np.uint8]:
    """Return the pheromone of each cell of the map, before the first cycle and after each, uint8[cycles + 1, n]."""
    return np.stack([in_decades(row, DECADES).ravel() for row in _finite(recording)])


def _finite(recording: Recording) -> Any:
    return (np.nan_to_num(row) for row in recording.pheromone)


def _window(recordings: Mapping[str, Recording], levels: Mapping[str, NDArray[np.uint8]]) -> list[int]:
    """Return what of a large map there is to be seen, as [top, left, bottom, right]: where ants were, and a margin."""
    grid = next(iter(recordings.values())).grid
    rows, cols = grid.shape
    if max(rows, cols) <= _SMALL:
        return [0, 0, rows, cols]
    seen = np.zeros(grid.shape, dtype=np.bool_)
    seen[grid.start] = seen[grid.goal] = True
    for each in levels.values():
        common = np.median(each, axis=1, keepdims=True)
        seen |= (each > common).any(axis=0).reshape(grid.shape)
    row, col = np.nonzero(seen)
    margin = max(rows, cols) // 40
    low = np.maximum([row.min() - margin, col.min() - margin], 0)
    high = np.minimum([row.max() + margin + 1, col.max() + margin + 1], grid.shape)
    return [int(number) for number in (*low, *high)]


_SMALL = 64
"""Cells on a side of a map that is shown whole."""


def _shown_ants(recording: Recording) -> list[list[int]]:
    """Return the ants of each cycle that are shown: some of many, evenly chosen, the cycle's best among them."""
    ants = recording.settings.scalars.ants
    some = np.unique(np.linspace(0, ants - 1, min(ants, MOST_ANTS)).round().astype(int)).tolist()
    return [some if best < 0 or best in some else [best, *some[1:]] for best in recording.winners.tolist()]


def _packed_ways(recording: Recording, shown: list[list[int]]) -> dict[str, Any]:
    winners, turns, steps, lost, best = recording.winners.tolist(), [], [], [], []
    for cycle, (ants, winner) in enumerate(zip(shown, winners, strict=True), 1):
        ways: list[Way] = recording.ways(cycle)
        for ant in ants:
            moves = ways[ant].moves
            turns.append(np.diff(moves, prepend=np.uint8(0)) & 7)
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
    return (moves + ord("0")).tobytes().decode("ascii")


def _deflated(values: NDArray[Any]) -> str:
    return b64encode(zlib.compress(np.ascontiguousarray(values).tobytes(), 9)).decode("ascii")
