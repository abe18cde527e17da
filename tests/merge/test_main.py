"""``python -m acoexp.merge``: what it says, and what it refuses before anything is written."""

from __future__ import annotations

import shutil
import sqlite3
import time
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from socket import socket

import pytest
from running import listing

from acoexp.merge.__main__ import main
from acoexp.tracking.mlflow.store import PATIENCE
from acoexp.tracking.mlflow.tracker import MlflowTracker

Prepared = Callable[[Path], MlflowTracker]
Capture = pytest.CaptureFixture[str]


def refusal(*argv: str, capsys: Capture) -> str:
    """Return what the command says where it ends with status 1."""
    with pytest.raises(SystemExit, match="1"):
        main(list(argv))
    said = capsys.readouterr().err
    assert said.startswith("acoexp: error: ")
    assert said.count("\n") == 1
    return said.removeprefix("acoexp: error: ")


def test_it_says_how_many_runs_it_brought_and_how_many_not(
    elsewhere: Path, prepared: Prepared, tmp_path: Path, capsys: Capture
) -> None:
    prepared(tmp_path / "mlflow.db")
    for brought, known in ((4, 0), (0, 4)):
        main([str(elsewhere), "--into", str(tmp_path / "mlflow.db")])
        assert capsys.readouterr().out == (
            f"{brought} runs brought from sqlite:///{elsewhere}; {known} were there already, 1 are not finished\n"
        )


def test_the_store_that_runs_are_brought_into_is_made_if_it_is_not_there(
    elsewhere: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.chdir(tmp_path)
    main([str(elsewhere)])
    assert capsys.readouterr().out.startswith("4 runs brought")
    assert (tmp_path / "outputs" / "mlflow.db").is_file()


def test_a_batch_whose_artifacts_are_gone_is_told_of(
    elsewhere: Path, prepared: Prepared, tmp_path: Path, capsys: Capture
) -> None:
    shutil.copy(elsewhere, tmp_path / "alone.db")
    prepared(tmp_path / "mlflow.db")
    said = refusal(str(tmp_path / "alone.db"), "--into", f"sqlite:///{tmp_path}/mlflow.db", capsys=capsys)
    assert said.startswith("run ")
    assert "expected its artifacts in " in said


def test_the_runs_of_further_stores_are_brought_all_the_same(
    elsewhere: Path, prepared: Prepared, tmp_path: Path, capsys: Capture
) -> None:
    shutil.copy(elsewhere, tmp_path / "alone.db")
    prepared(tmp_path / "mlflow.db")
    with pytest.raises(SystemExit, match="1"):
        main([str(tmp_path / "alone.db"), str(elsewhere), "--into", str(tmp_path / "mlflow.db")])
    out, err = capsys.readouterr()
    assert [line.partition(" from ")[0] for line in out.splitlines()] == ["3 runs brought", "1 runs brought"]
    assert out.splitlines()[0].endswith("; 0 were there already, 1 are not finished, 1 are refused")
    assert err.count("\n") == 1


@pytest.mark.parametrize("source", ["nowhere.db", "sqlite:///nowhere.db", "sqlite://"])
def test_a_store_that_is_not_there_is_refused_and_not_made(
    source: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.chdir(tmp_path)
    assert "expected" in refusal(source, capsys=capsys)
    assert listing(tmp_path) == set()


def test_a_server_that_is_not_there_is_told_soon_and_nothing_is_made(tmp_path: Path, capsys: Capture) -> None:
    with socket() as nobody:  # bound, and not listening
        nobody.bind(("127.0.0.1", 0))
        address = f"http://me:secret@127.0.0.1:{nobody.getsockname()[1]}"
        began = time.monotonic()
        said = refusal(address, "--into", str(tmp_path / "mlflow.db"), capsys=capsys)
    assert time.monotonic() - began < PATIENCE / 2
    assert "cannot be opened" in said
    assert "secret" not in said
    assert listing(tmp_path) == set()


def test_a_store_without_our_experiment_is_refused(blank: Path, tmp_path: Path, capsys: Capture) -> None:
    said = refusal(str(blank), "--into", str(tmp_path / "mlflow.db"), capsys=capsys)
    assert said.startswith("tracking.uri: no experiment 'acoexp' at sqlite:///")
    assert listing(tmp_path) == set()


def test_a_file_that_is_no_store_is_refused_and_left_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("notes.txt").write_text("nothing of MLflow's", encoding="utf-8")
    with closing(sqlite3.connect("other.db")) as database:
        database.execute("CREATE TABLE mine (x)")
    before = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    for name in before:
        said = refusal(name, capsys=capsys)
        assert said.startswith(f"expected an MLflow database to bring runs from; {tmp_path / name} is none")
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == before


def test_a_source_that_another_program_holds_is_told_to_be_locked(
    elsewhere: Path, tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("acoexp.tracking.mlflow.database.BUSY", 0.1)
    with closing(sqlite3.connect(elsewhere, isolation_level=None)) as holder:
        holder.execute("BEGIN EXCLUSIVE")
        said = refusal(str(elsewhere), "--into", str(tmp_path / "mlflow.db"), capsys=capsys)
        holder.execute("ROLLBACK")
    assert "database is locked; another program holds it" in said


def test_a_store_is_not_merged_into_itself(elsewhere: Path, capsys: Capture) -> None:
    said = refusal(str(elsewhere), "--into", f"sqlite:///{elsewhere}", capsys=capsys)
    assert said.startswith("expected a store other than the one")


def test_an_interruption_says_that_what_was_brought_is_kept(
    elsewhere: Path, prepared: Prepared, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    prepared(tmp_path / "mlflow.db")
    monkeypatch.setattr("acoexp.merge.__main__.merge", interrupted)
    with pytest.raises(SystemExit, match="130"):
        main([str(elsewhere), "--into", str(tmp_path / "mlflow.db")])
    assert capsys.readouterr().err == "acoexp: interrupted; what was brought is kept\n"


def test_it_brings_the_runs_of_the_experiment_that_is_named(
    elsewhere: Path, prepared: Prepared, tmp_path: Path, capsys: Capture
) -> None:
    prepared(tmp_path / "mlflow.db")
    said = refusal(str(elsewhere), "--into", str(tmp_path / "mlflow.db"), "--experiment", "x", capsys=capsys)
    assert said.startswith("tracking.uri: no experiment 'x' at ")
