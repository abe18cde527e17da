"""What ROS's map_server reads: a description in YAML beside an image, and the occupancy that a pixel stands for.

A pixel's shade is the mean of its channels, v of 255; the lighter, the freer, unless the description negates
that. With p = 1 - v/255, or v/255 negated, the modes are:

- ``trinary``: occupied where p >= occupied_thresh, free where p <= free_thresh, else unknown;
- ``scale``: the same, but 0 to 100 in proportion between the thresholds;
- ``raw``: v itself, up to 100; above that unknown. ``negate`` does not count.

Where alpha is below 255 a pixel is unknown.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import yaml
from numpy.typing import NDArray

from acoexp.console.bounded import check_bounded
from acoexp.errors import MapError, SettingsError, shown
from acoexp.parameters import REQUIRED, build, fields_of, parameter

UNKNOWN = -1
"""Occupancy of a cell of which nothing is known."""

_LONGEST = 2**16
"""Characters that a description may have."""
_MOST_VALUES = 1000
_FARTHEST = 1e9


@dataclass(frozen=True, kw_only=True)
class Description:
    """What the YAML says, ``origin`` parted into the lower left corner and the yaw."""

    image: str = parameter(REQUIRED, "the image's file, relative to the description's")
    resolution: float = parameter(REQUIRED, "side of a pixel in metres", above=0.0, maximum=_FARTHEST)
    origin: tuple[float, float] = parameter(REQUIRED, "(x, y) of the image's lower left corner in metres")
    yaw: float = parameter(REQUIRED, "angle by which it is turned, in radians", minimum=-1e3, maximum=1e3)
    negate: bool = parameter(REQUIRED, "whether dark is free")
    occupied_thresh: float = parameter(REQUIRED, "occupied from this on", minimum=0.0, maximum=1.0)
    free_thresh: float = parameter(REQUIRED, "free up to this", minimum=0.0, maximum=1.0)
    mode: str = parameter("trinary", "what a pixel stands for", choices=("trinary", "scale", "raw"))


def parse_description(text: str, name: str) -> Description:
    """Return what a description says; other keys than map_server's do not count.

    Args:
        text: The YAML.
        name: What the map is called in messages.

    Raises:
        MapError: if it is no YAML of a size that a description can have, if a key is missing or has another kind
            of value, or if the thresholds cross.
    """
    values = _mapping(text, name)
    origin = values.pop("origin", REQUIRED)
    if origin != REQUIRED:
        if not isinstance(origin, list) or len(origin) != 3:
            raise MapError(f"map {name}: origin: expected three numbers [x, y, yaw]; got {shown(origin)}")
        x, y, values["yaw"] = map(_number, origin)
        values["origin"] = [x, y]
    for key in ("resolution", "occupied_thresh", "free_thresh"):
        if key in values:
            values[key] = _number(values[key])
    if values.get("negate") in (0, 1):
        values["negate"] = bool(values["negate"])
    try:
        found: Description = build(Description, values, f"map {name}: ")
    except SettingsError as problem:
        raise MapError(str(problem)) from problem
    if max(map(abs, found.origin)) > _FARTHEST:
        raise MapError(f"map {name}: origin: expected metres up to {_FARTHEST:g}; got {shown(found.origin)}")
    if found.free_thresh >= found.occupied_thresh:
        raise MapError(
            f"map {name}: free_thresh: expected one below occupied_thresh, {found.occupied_thresh}; got "
            f"{found.free_thresh}"
        )
    return found


def occupancy(pixels: NDArray[np.uint8], description: Description) -> NDArray[np.int8]:
    """Return what map_server publishes, row 0 on top: 0 (free) to 100 (occupied), or ``UNKNOWN``.

    Args:
        pixels: uint8[rows, columns, 4], red, green, blue, alpha.
        description: What they stand for.

    Returns:
        int8[rows, columns].
    """
    sums = pixels[..., :3].sum(axis=2, dtype=np.uint16)
    found: NDArray[np.int8] = _values(description)[sums]
    found[pixels[..., 3] < 255] = UNKNOWN
    return found


def free_up_to(description: Description) -> int:
    """Return the largest occupancy that stands for a free cell.

    What lies between free and occupied is in ``trinary`` unknown. In the other modes it is a likelihood of an
    obstacle, and nobody vouches for such a cell: ``scale`` has made its free ones 0, and of ``raw`` values
    map_server's own map_saver takes those up to 100 free_thresh as free.
    """
    if description.mode != "raw":
        return 0
    return max(value for value in range(101) if value / 100 <= description.free_thresh)


def _values(description: Description) -> NDArray[np.int8]:
    """Return the occupancy for each sum of three channels, int8[766]."""
    shade = np.arange(766) / 765
    if description.mode == "raw":
        raw = np.rint(255 * shade)
        return np.where(raw <= 100, raw, UNKNOWN).astype(np.int8)
    free, occupied = description.free_thresh, description.occupied_thresh
    p = shade if description.negate else 1 - shade
    between = np.interp(p, [free, occupied], [0, 100]) if description.mode == "scale" else UNKNOWN
    values: NDArray[np.int8] = np.rint(np.select([p >= occupied, p <= free], [100, 0], between)).astype(np.int8)
    return values


def _mapping(text: str, name: str) -> dict[str, Any]:
    """Return the keys of a description that count, with their values."""
    expected = f"map {name}: expected map_server's YAML, the keys image, resolution, origin and so on"
    if len(text) > _LONGEST:
        raise MapError(f"{expected}; got {len(text)} characters, more than {_LONGEST}")
    try:
        check_bounded(text, _MOST_VALUES)
        content = yaml.safe_load(text)
    except RecursionError as problem:
        raise MapError(f"{expected}; got what is too deep") from problem
    except yaml.MarkedYAMLError as problem:
        line = "" if problem.problem_mark is None else f" in line {problem.problem_mark.line + 1}"
        raise MapError(f"{expected}; got {shown(problem.problem)}{line}") from problem
    except (yaml.YAMLError, ValueError, TypeError, AttributeError, LookupError) as problem:  # as of no such date
        raise MapError(f"{expected}; got what cannot be read: {shown(str(problem))}") from problem
    if not isinstance(content, dict):
        raise MapError(f"{expected}; got {shown(content)}")
    return {key: content[key] for key in fields_of(Description) if key in content and key != "yaw"}


def _number(value: Any) -> Any:
    """Return a number that YAML takes as a text, as it does 1e-05, as one."""
    try:
        return float(value) if isinstance(value, str) else value
    except ValueError:
        return value
