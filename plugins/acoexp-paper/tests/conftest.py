"""A small report, written once: few trials, few cycles, two further maps, two readings."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from acoexp_paper import experiment, readings
from acoexp_paper.report import Paper
from small import ENSEMBLE_TRIALS, MAPS, TRIALS, context

from acoexp.maps import ensemble


@pytest.fixture(scope="session")
def smaller() -> Iterator[Paper]:
    """The report with fewer further maps and readings, so that no kernel is compiled that others do not need."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(experiment, "ensemble", lambda env: ensemble(env)[:MAPS])
        nearest = readings.Reading("field.obstacles=nearest", {"field": {"obstacles": "nearest"}})
        patch.setattr(readings, "READINGS", (readings.DEFAULT, nearest))
        yield Paper(trials=TRIALS, ensemble_trials=ENSEMBLE_TRIALS)


@pytest.fixture(scope="session")
def report(smaller: Paper, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report's folder."""
    return smaller.write(context(tmp_path_factory.mktemp("report") / "paper"))
