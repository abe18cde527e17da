"""The artifacts of a run that is brought: files where the store's own artifacts lie, and nothing else.

A store may come from anybody, and whoever wrote it named the folder of each run's artifacts: a home, say.
"""

from __future__ import annotations

import stat
from collections.abc import Iterator
from itertools import accumulate
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from acoexp.errors import TrackingError
from acoexp.tracking.mlflow.moving import local_folder
from acoexp.tracking.mlflow.store import Store

if TYPE_CHECKING:
    from mlflow.entities import Run

_SERVED = "mlflow-artifacts"
"""Scheme of artifacts that an MLflow server hands out itself."""


def artifacts_of(source: Store, run: Run, folder: Path) -> list[tuple[Path, str | None]]:
    """Return a run's artifacts, each with the folder that it lies in among them.

    Args:
        source: The store that the run is in.
        run: The run.
        folder: An empty folder, for what has to be fetched.

    Raises:
        TrackingError: if they lie elsewhere than the store's own, lead there, or are not to be found.
    """
    try:
        place = _place(source, run, folder)
        return [] if place is None else [*_files(place)]
    except (OSError, ValueError, TypeError, RecursionError) as problem:  # a TrackingError is one as well
        raise problem if isinstance(problem, TrackingError) else _refusal(f"to be read; {problem}") from problem


def _place(source: Store, run: Run, folder: Path) -> Path | None:
    """Return the folder with a run's artifacts; None if it has none."""
    needed = "trials" in run.data.metrics
    if source.uri.startswith(("http:", "https:")):
        if urlsplit(run.info.artifact_uri).scheme == _SERVED:
            return _fetched(source, run, folder)
        if needed:
            raise _refusal(f"handed out by that server; got {run.info.artifact_uri}")
        return None
    root = (source.folder or Path("outputs").absolute()) / "artifacts"
    named = local_folder(run.info.artifact_uri)
    if named is None or ".." in named.parts:
        raise _refusal(f"in {root}; got {run.info.artifact_uri}")
    # a store that was moved or copied names folders of where it was before
    place = named if named.is_relative_to(root) else root.joinpath(*named.relative_to(named.anchor).parts[-2:])
    if place != root and place.is_dir():
        _refuse_links(root, place)
        return place
    if _is_elsewhere(named):
        raise _refusal(f"in {place}; got {named}: name the store that these are of")
    if needed:
        raise _refusal(f"in {place}; got neither that folder nor {named}")
    return None


def _is_elsewhere(folder: Path) -> bool:
    try:
        return folder.is_dir()
    except OSError:  # there is something, of another user's
        return True


def _fetched(source: Store, run: Run, folder: Path) -> Path:
    """Fetch artifacts from a server; MLflow itself refuses names that would leave the folder."""

    def fetch() -> str:
        return str(source.client.download_artifacts(run.info.run_id, "", str(folder)))

    return Path(source.with_retries(fetch, "cannot be read"))


def _refuse_links(root: Path, place: Path) -> None:
    """Refuse a folder if a part of the way to it, from a root on, is a link."""
    for part in accumulate(place.relative_to(root).parts, Path.joinpath, initial=root):
        if part.is_symlink():
            raise _refusal(f"in {root}; got a link, {part}")


def _files(place: Path) -> Iterator[tuple[Path, str | None]]:
    """Yield the files in a folder, by name, each with the folder that it lies in there."""
    for path in sorted(place.iterdir()):
        mode = path.lstat().st_mode
        if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)) or not path.name.isprintable():
            raise _refusal(f"to be files and folders with names that can be shown; got {path}")
        if stat.S_ISREG(mode):
            yield path, None
            continue
        for file, inside in _files(path):
            yield file, path.name if inside is None else f"{path.name}/{inside}"


def _refusal(reason: str) -> TrackingError:
    return TrackingError(f"expected its artifacts {reason}")
