"""The only trial of a command: what is seen, and what lies in its folder, before it is kept."""

from __future__ import annotations

from pathlib import Path

import pytest
from running import listing

from acoexp import Grid
from acoexp.command.alone import keep_alone
from acoexp.errors import TrackingError
from acoexp.registry.resolve import resolve
from acoexp.runs.trial import keep_trial
from acoexp.tracking.setup import Setup, Trial
from acoexp.tracking.tracker import NoTracker

YARD = Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard")
SETUP = Setup.of(resolve("aco", {"iterations": 4, "ants": 2}), YARD)
WRITTEN = {"trial.json", "path.csv"}
DRAWN = {"path.png", "convergence.png"}


class Looking(NoTracker):
    """Notes what is printed, and what lies in a folder, when it is made ready and when it is given a trial."""

    def __init__(
        self, folder: Path, capsys: pytest.CaptureFixture[str], problem: BaseException | None = None
    ) -> None:
        self.folder, self.capsys, self.problem = folder, capsys, problem
        self.seen: list[tuple[str, set[str]]] = []

    def prepare(self) -> None:
        self.seen.append((self.capsys.readouterr().out, listing(self.folder)))
        if self.problem is not None:
            raise self.problem

    def log(self, trial: Trial, *, resume: bool = True) -> None:
        self.seen.append((self.capsys.readouterr().out, {*trial.artifacts}))


def keep(tracker: NoTracker, folder: Path) -> Trial:
    """Run and keep a trial on a small map."""
    return keep_alone(lambda **how: keep_trial(SETUP, 3, tracker, **how), tracker, folder, Path("outputs/here"))


def test_its_figures_and_its_files_are_there_before_the_store_is_made_ready(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tracker = Looking(tmp_path, capsys)
    keep(tracker, tmp_path)
    (shown, files), (nothing, carried) = tracker.seen
    assert [line.split()[0] for line in shown.splitlines()] == ["algo", "aco", "files:", "pictures"]
    assert files == WRITTEN | DRAWN
    assert (nothing, carried) == ("", {"path.csv", "path.png"})
    assert capsys.readouterr().out == "run:   not tracked\n"


def test_where_it_cannot_be_kept_nothing_says_that_it_is(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(TrackingError, match=r"^the disk is full$"):
        keep(Looking(tmp_path, capsys, TrackingError("the disk is full")), tmp_path)
    assert capsys.readouterr().out == ""
    assert listing(tmp_path) == WRITTEN | DRAWN


def test_ctrl_c_meanwhile_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(KeyboardInterrupt, match=r"^this trial may not be kept$"):
        keep(Looking(tmp_path, capsys, KeyboardInterrupt()), tmp_path)
    assert capsys.readouterr().out == ""


def test_a_path_that_cannot_be_written_is_an_error_and_the_record_is_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "path.csv").mkdir()
    with pytest.raises(OSError, match=r"path\.csv"):
        keep(Looking(tmp_path, capsys), tmp_path)
    assert (tmp_path / "trial.json").exists()
