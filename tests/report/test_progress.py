"""Progress: seen on a terminal alone, in place of the log's line for each batch."""

from __future__ import annotations

import logging

import pytest

from acoexp.report.progress import shown_progress
from acoexp.runs import batch


def test_a_terminal_shows_the_batch_and_the_trials_of_all_batches(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    with shown_progress(30) as show:
        show("aco on fig13", 10)
        show("pd on fig13", 3)
        show("pd on fig13", 7)
    shown = capsys.readouterr()
    assert shown.out == ""
    assert "17/30" in shown.err
    assert "pd on fig13" in shown.err


def test_nothing_is_shown_without_a_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    with shown_progress(30) as show:
        show("aco on fig13", 10)
    assert capsys.readouterr() == ("", "")


def test_batches_leave_no_line_in_the_log_until_all_have_run(caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO, batch.log.name)

    def run() -> None:
        with shown_progress(1):
            batch.log.info("one of hundreds")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run()
    batch.log.info("after them")
    assert caplog.messages == ["after them"]
