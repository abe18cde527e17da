"""What became of the jobs of a sweep that failed: a line for each, and an error for all."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import redirect_stderr
from io import StringIO

from hydra.core.utils import JobReturn, JobStatus
from omegaconf.errors import OmegaConfBaseException

from acoexp.command.messages import in_one_line
from acoexp.console.ending import print_error
from acoexp.errors import AcoexpError
from acoexp.tracking.mlflow.masking import masked


class JobsFailedError(AcoexpError):
    """Jobs of a sweep failed; each has been told of."""


def raise_if_failed(jobs: Sequence[JobReturn]) -> None:
    """Print a line for each job that failed, with what it was told and why.

    Raises:
        JobsFailedError: if there is one.
        Exception: what a job raised, if it is none of ours: its traceback is needed.
    """
    failed = print_failed(jobs)
    if failed:
        raise JobsFailedError(f"{failed} of {len(jobs)} jobs failed; the others are kept")


def print_failed(jobs: Sequence[JobReturn]) -> int:
    """Print a line for each job that failed, as :func:`raise_if_failed` does; return how many did."""
    failed = [job for job in jobs if job.status != JobStatus.COMPLETED]
    for job in failed:
        print_error(f"{masked(' '.join(job.overrides or ()))}: {_reason(job)}")
    return len(failed)


def _reason(job: JobReturn) -> str:
    try:
        with redirect_stderr(StringIO()):  # Hydra would print a line of its own
            return str(job.return_value)
    except (AcoexpError, OmegaConfBaseException, OSError) as problem:
        return in_one_line(problem)
