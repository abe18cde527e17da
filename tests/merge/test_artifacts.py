"""What a store may bring as a run's artifacts, whoever wrote it: the files where its own artifacts lie."""

from __future__ import annotations

import os
import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest
from running import listing

from acoexp.merge.artifacts import artifacts_of
from acoexp.merge.copying import Merged, RefusedError, merge
from acoexp.tracking.mlflow.store import Store
from acoexp.tracking.mlflow.tracker import MlflowTracker

Prepared = Callable[[Path], MlflowTracker]


@pytest.fixture
def theirs(elsewhere: Path, tmp_path: Path) -> Path:
    """Return the database of a stranger's store, with the artifacts of a batch beside it."""
    shutil.copytree(elsewhere.parent, tmp_path / "theirs")
    return tmp_path / "theirs" / elsewhere.name


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """Return a folder that is nobody's business."""
    (tmp_path / "home" / ".ssh").mkdir(parents=True)
    (tmp_path / "home" / ".ssh" / "id").write_text("secret", encoding="utf-8")
    return tmp_path / "home"


def artifacts(theirs: Path) -> Path:
    """Return the folder of the only run with artifacts."""
    (folder,) = (theirs.parent / "artifacts").glob("*/artifacts")
    return folder


def name_for_all(theirs: Path, place: str | None) -> None:
    """Let the store name a place as every run's artifacts."""
    with closing(sqlite3.connect(theirs)) as database, database:
        database.execute("UPDATE runs SET artifact_uri = ?", (place,))


def refusal(theirs: Path, prepared: Prepared, tmp_path: Path, brought: int = 3) -> str:
    """Bring a store, look that the runs without such artifacts come and nothing of the others does; return why."""
    here = prepared(tmp_path / "here" / "mlflow.db")
    with pytest.raises(RefusedError) as caught:
        merge(Store(f"sqlite:///{theirs}"), here.store)
    assert caught.value.merged == Merged(brought, 0, 1, 4 - brought)
    assert len(here.store.search("")) == brought
    assert listing(tmp_path / "here") == {"mlflow.db", "mlflow.db.lock"}
    return str(caught.value)


def test_the_files_beside_the_database_are_brought(theirs: Path, prepared: Prepared, tmp_path: Path) -> None:
    here = prepared(tmp_path / "here" / "mlflow.db")
    (artifacts(theirs) / "notes" / "more").mkdir(parents=True)
    (artifacts(theirs) / "notes" / "more" / "a b.txt").write_text("theirs", encoding="utf-8")
    assert merge(Store(f"sqlite:///{theirs}"), here.store) == Merged(4, 0, 1)
    (brought,) = (tmp_path / "here" / "artifacts").glob("*/artifacts")
    assert listing(brought) == listing(artifacts(theirs))
    assert (brought / "notes" / "more" / "a b.txt").read_text("utf-8") == "theirs"


@pytest.mark.parametrize("place", ["{home}", "file://{home}/.ssh", "{home}/.ssh", "file:///{home}", "///{home}"])
def test_a_folder_elsewhere_is_refused(
    place: str, theirs: Path, home: Path, prepared: Prepared, tmp_path: Path
) -> None:
    name_for_all(theirs, place.format(home=home))
    said = refusal(theirs, prepared, tmp_path, brought=0)
    assert said.startswith("run ")
    assert f" of sqlite:///{theirs}: expected its artifacts in {theirs.parent}/artifacts/" in said
    assert f"{home}" in said.partition("got ")[2]
    assert said.endswith(": name the store that these are of")


@pytest.mark.parametrize(
    "place", ["artifacts/../../home/.ssh", "file:{folder}/artifacts/x/../../../home", "/..", "file:///a/%2e%2e/b"]
)
def test_a_way_up_is_refused(place: str, theirs: Path, home: Path, prepared: Prepared, tmp_path: Path) -> None:
    name_for_all(theirs, place.format(folder=theirs.parent))
    assert f"expected its artifacts in {theirs.parent}/artifacts; got " in refusal(theirs, prepared, tmp_path, 0)


@pytest.mark.parametrize("place", ["http://127.0.0.1:9/x", "s3://bucket/x", "mlflow-artifacts:/1/x", "ftp://h/x"])
def test_a_place_on_a_network_is_refused_and_not_asked(
    place: str, theirs: Path, prepared: Prepared, tmp_path: Path
) -> None:
    name_for_all(theirs, place)
    assert f"; got {place}" in refusal(theirs, prepared, tmp_path, brought=0)


@pytest.mark.parametrize("place", [None, "file://[::1/x", "x" * 100_000])
def test_what_is_no_place_is_refused_for_that_run_alone(
    place: str | None, theirs: Path, prepared: Prepared, tmp_path: Path
) -> None:
    name_for_all(theirs, place)
    assert "expected its artifacts " in refusal(theirs, prepared, tmp_path, brought=0)


@pytest.mark.parametrize("place", ["", "/", "file:///", "."])
def test_all_artifacts_of_a_store_are_not_those_of_a_run(
    place: str, theirs: Path, prepared: Prepared, tmp_path: Path
) -> None:
    name_for_all(theirs, place)
    refusal(theirs, prepared, tmp_path, brought=0)


@pytest.mark.parametrize(
    "linked", ["artifacts", "artifacts/*", "artifacts/*/artifacts", "artifacts/*/artifacts/trials"]
)
def test_a_link_on_the_way_is_refused(
    linked: str, theirs: Path, home: Path, prepared: Prepared, tmp_path: Path
) -> None:
    (folder,) = theirs.parent.glob(linked)
    folder.replace(home / "theirs")
    folder.symlink_to(home / "theirs")
    said = refusal(theirs, prepared, tmp_path)
    assert said.endswith(f"; got {folder}" if linked.endswith("trials") else f"; got a link, {folder}")


@pytest.mark.parametrize("kind", ["link", "folder's link", "pipe", "a name that is a command"])
def test_what_is_no_file_with_a_name_is_refused(
    kind: str, theirs: Path, home: Path, prepared: Prepared, tmp_path: Path
) -> None:
    odd = artifacts(theirs) / "trials" / "odd"
    if "link" in kind:
        odd.symlink_to(home if "folder" in kind else home / ".ssh" / "id")
    elif kind == "pipe":
        os.mkfifo(odd)
    else:
        odd = odd.with_name("\x1b[31m")
        odd.touch()
    said = f"expected its artifacts to be files and folders with names that can be shown; got {odd}"
    assert refusal(theirs, prepared, tmp_path).endswith(said)


def test_artifacts_that_are_nowhere_are_told_of(theirs: Path, prepared: Prepared, tmp_path: Path) -> None:
    shutil.rmtree(theirs.parent / "artifacts")
    assert "got neither that folder nor " in refusal(theirs, prepared, tmp_path)


def test_of_a_server_only_what_it_hands_out_itself_is_fetched(theirs: Path, tmp_path: Path) -> None:
    """As if the store were asked through a server that says where the artifacts are."""
    store = Store(f"sqlite:///{theirs}")
    (batch,) = (run for run in store.search("") if "trials" in run.data.metrics)
    store.uri = "http://127.0.0.1:9"
    with pytest.raises(OSError, match=r"^expected its artifacts handed out by that server; got "):
        artifacts_of(store, batch, tmp_path)
