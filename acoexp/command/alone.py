"""The only trial of a command: seen as soon as it is solved, then drawn, then kept.

What its pictures and its store need takes seconds to import, and nobody waits for that to see the figures.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from acoexp.command.results.artifacts import pictured
from acoexp.command.results.contents import trial_record
from acoexp.command.results.paths import write_path
from acoexp.command.results.records import TRIAL, write_record
from acoexp.command.results.table import print_run, print_trial
from acoexp.tracking.setup import Trial
from acoexp.tracking.tracker import Tracker


def keep_alone(keep: Callable[..., Trial], tracker: Tracker, folder: Path, named: Path) -> Trial:
    """Run and keep a trial; say where its run is once it is there.

    Args:
        keep: Runs and keeps it; see :func:`acoexp.runs.trial.keep_trial`.
        tracker: Where it is kept, which is not ready yet.
        folder: The job's folder.
        named: What that is called for a person.

    Raises:
        KeyboardInterrupt: with what is said of this trial.
    """
    try:
        trial = keep(
            show=partial(_show, folder, named), artifacts=partial(pictured, folder), ready=tracker.prepare
        )
    except KeyboardInterrupt:
        raise KeyboardInterrupt("this trial may not be kept") from None
    print_run(tracker.where)
    return trial


def _show(folder: Path, named: Path, trial: Trial) -> None:
    """Leave the trial's record and its path, and print what it found."""
    write_record(folder / TRIAL, trial_record(trial))
    write_path(trial.result, folder)
    print_trial(folder, named)
