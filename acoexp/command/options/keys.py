"""The keys of a job that are of no part: which trials, by how many threads, and whether kept ones count."""

from __future__ import annotations

from dataclasses import dataclass

from acoexp.parameters import parameter
from acoexp.registry.entries import GROUPS
from acoexp.trial.seeds import HIGHEST_SEED
from acoexp.trial.threads import MOST_THREADS

OPTIONS = (*GROUPS, "algo", "tracking", "engine")
"""Keys whose values are names of options."""


@dataclass(frozen=True, kw_only=True)
class ReportKeys:
    """What every report has beside its own keys."""

    folder: str | None = parameter(
        None, "folder that a report is written to; if null a report's name in outputs/reports, or in hydra.run.dir"
    )


@dataclass(frozen=True, kw_only=True)
class JobKeys:
    """What a job runs."""

    seed: int = parameter(
        0, "whole number that the trial's random numbers follow from", minimum=0, maximum=HIGHEST_SEED
    )
    seeds: str | None = parameter(
        None, "instead, those of a batch, such as 0-999: one run with a table of its trials"
    )
    threads: int | None = parameter(
        None, "threads that run a batch; one for each processor if null", minimum=1, maximum=MOST_THREADS
    )
    resume: bool = parameter(True, "whether what the store has of the same trials is taken from there")
