"""Jobs of a sweep that failed: a line for each, one error for all, and a traceback for what nobody foresaw."""

from __future__ import annotations

import pytest
from hydra.core.utils import JobReturn, JobStatus

from acoexp.command.sweep.failed import JobsFailedError, print_failed, raise_if_failed
from acoexp.errors import StrategyError

Capture = pytest.CaptureFixture[str]


def job(seed: int, problem: Exception | None = None) -> JobReturn:
    """Return what a launcher says of a job."""
    status = JobStatus.COMPLETED if problem is None else JobStatus.FAILED
    return JobReturn(overrides=["algo=pd", f"seed={seed}"], status=status, _return_value=problem or 35.0)


def test_jobs_that_all_ended_well_say_nothing(capsys: Capture) -> None:
    raise_if_failed([job(0), job(1)])
    raise_if_failed([])
    assert capsys.readouterr() == ("", "")


def test_each_job_that_failed_says_what_it_was_told_and_why(capsys: Capture) -> None:
    jobs = [job(0), job(1, StrategyError("the part\nbroke")), job(2), job(3, StrategyError("it broke again"))]
    with pytest.raises(JobsFailedError, match=r"^2 of 4 jobs failed; the others are kept$"):
        raise_if_failed(jobs)
    assert capsys.readouterr().err.splitlines() == [
        "acoexp: error: algo=pd seed=1: the part broke",
        "acoexp: error: algo=pd seed=3: it broke again",
    ]


def test_jobs_that_may_fail_are_told_of_and_counted(capsys: Capture) -> None:
    assert print_failed([job(0), job(1, StrategyError("the part broke"))]) == 1
    assert capsys.readouterr().err == "acoexp: error: algo=pd seed=1: the part broke\n"


def test_what_nobody_foresaw_is_raised_as_it_was(capsys: Capture) -> None:
    with pytest.raises(ZeroDivisionError):
        raise_if_failed([job(0, ZeroDivisionError())])
