"""Records: their presence says that a job is finished, and how far the others are stands beside them."""

from __future__ import annotations

import json
import math
from pathlib import Path

from acoexp.command.results.records import (
    BATCH,
    PROGRESS,
    TRIAL,
    in_progress,
    read_record,
    records_below,
    trials_done,
    write_progress,
    write_record,
)


def job(folder: Path, name: str) -> Path:
    """Return the folder of a job."""
    (folder / name).mkdir(parents=True, exist_ok=True)
    return folder / name


def test_a_record_reads_back_with_null_where_a_number_was_none(tmp_path: Path) -> None:
    content = {
        "l1": 7.5,
        "l2": math.nan,
        "means": {"x1": math.nan, "l1": 8.0},
        "curve": [math.nan, 7.5],
        "seed": 2**64 - 1,
    }
    write_record(tmp_path / TRIAL, content)
    read = {"l1": 7.5, "l2": None, "means": {"x1": None, "l1": 8.0}, "curve": [None, 7.5], "seed": 2**64 - 1}
    assert read_record(tmp_path / TRIAL) == read
    assert json.loads((tmp_path / TRIAL).read_text("utf-8"), parse_constant=lambda name: 1 / 0) == read


def test_all_records_below_a_folder_are_found_however_deep(tmp_path: Path) -> None:
    places = [job(tmp_path, "0") / TRIAL, job(tmp_path, "1/deeper") / BATCH, job(tmp_path, "2") / TRIAL]
    for place in places:
        write_record(place, {})
    write_progress(job(tmp_path, "3"), 5)
    assert sorted(records_below(tmp_path)) == sorted(places)
    assert records_below(tmp_path / "nowhere") == {}


def test_a_record_that_is_written_again_has_another_time(tmp_path: Path) -> None:
    write_record(tmp_path / TRIAL, {})
    before = records_below(tmp_path)
    write_record(tmp_path / TRIAL, {})
    assert records_below(tmp_path).keys() == before.keys()
    assert records_below(tmp_path) != before


def test_trials_are_done_in_records_and_in_batches_that_go_on(tmp_path: Path) -> None:
    write_record(job(tmp_path, "0") / TRIAL, {})
    write_record(job(tmp_path, "1") / TRIAL, {})
    write_progress(job(tmp_path, "2"), 40)
    write_progress(job(tmp_path, "3"), 100)
    write_record(tmp_path / "3" / BATCH, {})
    assert trials_done(tmp_path, records_below(tmp_path)) == 2 + 40 + 100
    assert (in_progress(tmp_path), in_progress(tmp_path, finished=False)) == (140, 40)


def test_progress_is_the_last_that_was_noted(tmp_path: Path) -> None:
    for done in (2000, 3999, 4000):
        write_progress(tmp_path, done)
        assert in_progress(tmp_path) == done
    assert [file.name for file in tmp_path.iterdir()] == [PROGRESS]
