"""A found map as the text of a map file: its rule, where it comes from, how it fits, and how to find it again."""

from __future__ import annotations

import numpy as np

from acoexp.errors import MapError, SettingsError
from acoexp.maps.file import MapFile
from acoexp.reconstruct.fit import Fit
from acoexp.reconstruct.layout import Layout, is_layout, paint
from acoexp.reconstruct.published import Environment

ORIGIN = (
    "reconstruction (the paper's figure is lost): "
    "rectangles searched for the published optimum under standard ACO alone"
)


def map_text(layout: Layout, moves: str, environment: Environment, fit: Fit, command: str) -> str:
    """Return a map file's text; :func:`acoexp.maps.parse_map` reads it.

    Its metadata: ``moves``, ``origin``, ``optimum``; ``rectangles`` as top left bottom right, the last two
    excluded; ``fit`` in words, then its numbers; the ``command`` that finds the map again.
    """
    straight, diagonal = environment.optimum
    metadata = {
        "moves": moves,
        "origin": ORIGIN,
        "optimum": f"{straight} straight, {diagonal} diagonal",
        "rectangles": ", ".join(" ".join(map(str, rectangle)) for rectangle in sorted(layout.tolist())),
        "fit": fit.in_words(environment),
        "trials": str(fit.trials),
        "l1": _counts(fit.l1),
        "l2": _counts(fit.l2),
        "score": f"{fit.score:.2f}",
        "command": command,
    }
    remarks = [f"; {key}: {value}" for key, value in metadata.items()]
    rows = ["".join("#" if cell else "." for cell in row) for row in paint(layout).tolist()]
    return "\n".join([*remarks, *rows]) + "\n"


def _counts(counts: dict[str, int]) -> str:
    return ", ".join(f"{length} {count}" for length, count in counts.items())


def read_layout(path: str, environment: Environment) -> tuple[Layout, str]:
    """Return the rectangles of a map file, and its rule for diagonals, to go on from.

    Raises:
        SettingsError: if it cannot be read, does not tell its rectangles, or has not the environment's optimum.
    """
    try:
        grid = MapFile(path=path).load()
    except MapError as problem:
        raise SettingsError(f"begin: {str(problem).removeprefix('map.path: ')}") from problem
    try:
        rectangles = grid.metadata["rectangles"].split(",")
        layout = np.array([[int(n) for n in rectangle.split()] for rectangle in rectangles]).reshape(-1, 4)
    except (KeyError, ValueError) as problem:
        raise SettingsError(
            f"begin: expected a map file with a line '; rectangles: ...'; got {path!r}"
        ) from problem
    if not is_layout(layout) or grid.optimum_pair != environment.optimum:
        raise SettingsError(f"begin: expected a 20 x 20 map with the optimum of {environment.name}; got {path!r}")
    return layout, grid.moves
