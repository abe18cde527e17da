"""Watching: what ended is counted whoever ran it and however that ended, and the table stands at its end."""

from __future__ import annotations

import re
import time
from io import StringIO
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

from acoexp.command.results import watch
from acoexp.command.results.records import BATCH, TRIAL, write_progress, write_record
from acoexp.command.results.watch import Watched, watching

Capture = pytest.CaptureFixture[str]


def trial(seed: int, **changes: Any) -> dict[str, Any]:
    """Return a trial as its record has it."""
    return {
        "algo": "pdg", "map": "env2", "seed": seed, "configuration_id": "c", "seconds": 0.002,
        "x1": 5, "x2": 6, "x3": 7, "l1": 11.0, "l2": 12.0, "optimum": 10.0, "lost_ants": [0],
        "config": {"algo": "pdg", "map.name": "env2", "seed": str(seed)},
    } | changes  # fmt: skip


def batch(trials: int, ran: int) -> dict[str, Any]:
    """Return a batch as its record has it."""
    names = ("x1", "x2", "x3", "l1", "l2", "lost_ants")
    return {
        "algo": "pdg", "map": "env2", "configuration_id": "c", "optimum": 10.0, "seconds": 0.002,
        "config": {"algo": "pdg", "map.name": "env2", "seeds": f"0-{trials - 1}"},
        "trials": trials, "ran": ran, "never_arrived": 0, "success_rate": 0.0, "expected_cycles": None,
        "means": dict.fromkeys(names, 11.0), "deviations": dict.fromkeys(names, 1.0),
    }  # fmt: skip


def put(folder: Path, job: str, name: str, record: dict[str, Any]) -> None:
    """Leave a record in a job's folder."""
    (folder / job).mkdir(parents=True, exist_ok=True)
    write_record(folder / job / name, record)


def ended(capsys: Capture) -> tuple[str, list[list[str]]]:
    """Return how it ended, without the time, and the rows of the table."""
    out, err = capsys.readouterr()
    assert err == ""  # no progress where there is no terminal
    (said,) = re.findall(r"^.* trials finished in .*$", out, re.M)
    return re.sub(r"\d+\.\d s", "0 s", said), [line.split() for line in out.splitlines() if line.startswith("pdg")]


def test_what_ended_while_it_watched_is_counted_and_in_the_table(tmp_path: Path, capsys: Capture) -> None:
    with watching(Watched(folder=tmp_path, where="nowhere", trials=3)):
        put(tmp_path, "0", TRIAL, trial(0))
        put(tmp_path, "1", TRIAL, trial(1))
    said, rows = ended(capsys)
    assert said == "2 of 3 trials finished in 0 s"
    assert [row[-2] for row in rows] == ["0/2"]


def test_what_was_there_before_is_nobodys_unless_it_is_written_again(tmp_path: Path, capsys: Capture) -> None:
    put(tmp_path, "0", TRIAL, trial(0))
    put(tmp_path, "1", TRIAL, trial(1))
    with watching(Watched(folder=tmp_path, where="nowhere", trials=1)):
        put(tmp_path, "1", TRIAL, trial(7))
    said, rows = ended(capsys)
    assert said == "1 of 1 trials finished in 0 s"
    assert [row[-2] for row in rows] == ["0/1"]


def test_what_the_store_had_is_in_the_table_and_did_not_run(tmp_path: Path, capsys: Capture) -> None:
    known = [trial(seed, seconds=None) for seed in range(4)]
    with watching(Watched(folder=tmp_path, where="nowhere", trials=5, known=known, found=4)):
        put(tmp_path, "0", TRIAL, trial(4))
    said, rows = ended(capsys)
    assert said == "1 of 5 trials finished in 0 s, 4 found in the store"
    assert [row[-2] for row in rows] == ["0/5"]


def test_of_a_batch_what_ran_and_what_was_found_are_told_apart(tmp_path: Path, capsys: Capture) -> None:
    with watching(Watched(folder=tmp_path, where="nowhere", trials=10)):
        put(tmp_path, "0", BATCH, batch(10, ran=4))
    assert ended(capsys)[0] == "4 of 10 trials finished in 0 s, 6 found in the store"


def test_an_interruption_prints_what_there_is_and_goes_on(tmp_path: Path, capsys: Capture) -> None:
    with (  # noqa: PT012
        pytest.raises(KeyboardInterrupt),
        watching(Watched(folder=tmp_path, where="nowhere", trials=100)),
    ):
        put(tmp_path, "0", TRIAL, trial(0))
        (tmp_path / "1").mkdir()
        write_progress(tmp_path / "1", 40)  # of a batch that is not finished
        raise KeyboardInterrupt
    said, rows = ended(capsys)
    assert said == "41 of 100 trials finished in 0 s"
    assert [row[-2] for row in rows] == ["0/1"]


def test_where_nobody_knows_how_many_trials_it_will_be_none_are_named(tmp_path: Path, capsys: Capture) -> None:
    with watching(Watched(folder=tmp_path, where="nowhere")):
        put(tmp_path, "0", TRIAL, trial(0))
    assert ended(capsys)[0] == "1 trials finished in 0 s"


def test_on_a_terminal_it_shows_how_far_the_jobs_are(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    screen = StringIO()
    console = Console(file=screen, force_terminal=True, width=80)
    monkeypatch.setattr(watch, "Console", lambda file: console)
    monkeypatch.setattr(watch, "_LOOK_EVERY", 0.01)
    with watching(Watched(folder=tmp_path, where="nowhere", trials=100, found=50)):
        put(tmp_path, "0", TRIAL, trial(0))
        (tmp_path / "1").mkdir()
        write_progress(tmp_path / "1", 40)
        deadline = time.monotonic() + 20.0
        while " 91/100" not in screen.getvalue():
            assert time.monotonic() < deadline
            time.sleep(0.01)
