"""The ensembles: further reconstructions of the paper's maps, to see how far a result depends on the map."""

from __future__ import annotations

from importlib.resources import files

from acoexp.errors import MapError
from acoexp.grid.grid import Grid
from acoexp.maps.text import parse_map

NAMES = ("fig13", "env1", "env2")


def ensemble(name: str) -> list[Grid]:
    """Return further reconstructions of a built-in map, each with its fit in its metadata.

    All have exactly the published optimum, and each is from a search of its own. They are called
    ``fig13-00``, ``fig13-01`` and so on, after the seed of that search; the built-in map is not among them.

    Args:
        name: ``fig13``, ``env1`` or ``env2``.

    Raises:
        MapError: for another name.
    """
    if name not in NAMES:
        raise MapError(f"ensemble: expected one of: {', '.join(NAMES)}; got {name!r}")
    folder = files("acoexp.maps").joinpath("data", "ensemble")
    found = sorted((file for file in folder.iterdir() if file.name.startswith(f"{name}-")), key=lambda f: f.name)
    return [parse_map(file.read_text(encoding="utf-8"), name=file.name.removesuffix(".txt")) for file in found]
