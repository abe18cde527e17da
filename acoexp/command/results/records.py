"""Records: what the jobs of a run or a sweep leave in their folders, and how far they are by it.

A record's presence says that its job is finished. What watches a sweep looks at nothing else, so it needs no word
from where the jobs run.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from acoexp.console.whole import write_whole
from acoexp.trial.features import without_nan

TRIAL, BATCH, PROGRESS = "trial.json", "batch.json", "progress"
"""Files in a job's folder: the record of a finished trial, or of a finished batch; how far a batch is."""

FAILED_JOB = "failed.txt"
"""File in a job's folder: why it failed."""


def write_record(file: Path, content: Mapping[str, Any]) -> None:
    """Write the record of a job, plain values for JSON; null where a number is not one."""
    write_whole(file, json.dumps(without_nan(dict(content))))


def write_progress(folder: Path, done: int) -> None:
    """Note in a job's folder how many trials of its batch are finished or failed."""
    write_whole(folder / PROGRESS, str(done))


def read_record(file: Path) -> dict[str, Any]:
    """Return a record as it was written."""
    record: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    return record


def records_below(folder: Path) -> dict[Path, int]:
    """Return the records of finished jobs below a folder, each with the time it was written, in ns."""
    return {file: file.stat().st_mtime_ns for name in (TRIAL, BATCH) for file in folder.rglob(name)}


def trials_done(folder: Path, records: Iterable[Path]) -> int:
    """Return how many trials are done below a folder, those of unfinished batches too."""
    return in_progress(folder) + sum(record.name == TRIAL for record in records)


def in_progress(folder: Path, finished: bool = True) -> int:
    """Return how many trials of batches are done below a folder, also of those that are finished or not."""
    files = (file for file in folder.rglob(PROGRESS) if finished or not file.with_name(BATCH).exists())
    return sum(int(file.read_text(encoding="utf-8")) for file in files)
