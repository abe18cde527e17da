"""A small report, written once, and the findings of made-up trials: two further maps, one other reading."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from acoexp_paper.claims.catalogue import CLAIMS
from acoexp_paper.claims.findings import Findings
from acoexp_paper.published.tables import ENVIRONMENTS
from acoexp_paper.report import Paper
from acoexp_paper.trials import experiment as experiments
from acoexp_paper.trials import readings
from acoexp_paper.trials.experiment import Experiment
from made import made_trials, make_up
from small import ENSEMBLE_TRIALS, MAPS, READING_TRIALS, TRIALS, context

from acoexp.maps.ensemble import ensemble
from acoexp.registry.load_map import load_map


@pytest.fixture(scope="session")
def few() -> Iterator[None]:
    """Fewer further maps and readings, so that no kernel is compiled that others do not need."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(experiments, "ensemble", lambda env: ensemble(env)[:MAPS])
        nearest = readings.Reading("field.obstacles=nearest", {"field": {"obstacles": "nearest"}})
        patch.setattr(readings, "READINGS", (nearest,))
        yield


@pytest.fixture(scope="session")
def smaller(few: None) -> Paper:
    """The report with fewer trials, too."""
    return Paper(trials=TRIALS, ensemble_trials=ENSEMBLE_TRIALS, reading_trials=READING_TRIALS)


@pytest.fixture(scope="session")
def report(smaller: Paper, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report's folder."""
    return smaller.write(context(tmp_path_factory.mktemp("report") / "paper"))


@pytest.fixture(scope="session")
def experiment(few: None, tmp_path_factory: pytest.TempPathFactory) -> Experiment:
    """As many trials, made up."""
    made = context(tmp_path_factory.mktemp("made"), made_trials)
    maps = {env: load_map(env) for env in ENVIRONMENTS}
    made_up = Experiment(made, maps, frozenset(), TRIALS, ENSEMBLE_TRIALS, READING_TRIALS)
    with pytest.MonkeyPatch.context() as patch:
        make_up(patch)
        assert made_up.samples  # run while they are made up
    return made_up


@pytest.fixture(scope="session")
def found(experiment: Experiment) -> Findings:
    """What they say of all averages and claims."""
    with pytest.MonkeyPatch.context() as patch:
        make_up(patch)
        return Findings.of(experiment, CLAIMS)
