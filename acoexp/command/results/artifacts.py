"""The artifacts of a run: the path of a trial, and its picture where the job leaves one in its folder."""

from __future__ import annotations

import logging
from pathlib import Path

from acoexp.command.results.paths import CSV, csv_lines, places_of
from acoexp.tracking.setup import Artifacts
from acoexp.trial.result import Result

log = logging.getLogger(__name__)

PICTURE, CONVERGENCE = "path.png", "convergence.png"
"""Pictures in a job's folder: the map with the path, and the curve."""


def carried(result: Result) -> Artifacts:
    """Return what each run carries: the path as CSV, where there is one."""
    places = places_of(result)
    return {} if places is None else {CSV: "".join(f"{line}\n" for line in csv_lines(places)).encode()}


def pictured(folder: Path, result: Result) -> Artifacts:
    """Draw a trial's pictures into a folder; return what its run carries: the path, and the picture of it.

    What cannot be drawn is only a warning.
    """
    artifacts = carried(result)
    try:
        from acoexp.command.results.pictures import (  # matplotlib takes its time to import
            draw_convergence,
            draw_map,
        )

        draw_map(result, folder / PICTURE)
        artifacts = {**artifacts, PICTURE: (folder / PICTURE).read_bytes()}
        draw_convergence(result, folder / CONVERGENCE)
    except Exception as problem:
        log.warning("the pictures could not be drawn: %s: %s", type(problem).__name__, problem)
    return artifacts
