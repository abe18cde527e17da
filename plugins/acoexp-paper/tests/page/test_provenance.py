"""What the report was made with."""

from __future__ import annotations

import platform
from dataclasses import replace
from importlib.metadata import version
from subprocess import CalledProcessError

import pytest
from acoexp_paper.page import provenance as module
from acoexp_paper.page.provenance import made_with, provenance
from acoexp_paper.trials.experiment import Experiment
from small import ENSEMBLE_TRIALS, READING_TRIALS, TRIALS


def test_versions_seeds_and_trials_are_said(experiment: Experiment) -> None:
    said = made_with(experiment)
    assert said["Python"] == platform.python_version()
    assert {name: said[name] for name in ("acoexp", "numpy", "numba")} == {
        name: version(name) for name in ("acoexp", "numpy", "numba")
    }
    assert said["seeds"] == (
        f"on each environment's own map 0 to {TRIALS - 1}; on the further maps 0 to {ENSEMBLE_TRIALS - 1}; "
        f"under other readings 0 to {READING_TRIALS - 1}"
    )
    alone = replace(experiment, ensemble_trials=0, reading_trials=0)
    assert made_with(alone)["trials"] == str(TRIALS * (3 + 2 + 4))
    assert made_with(alone)["seeds"] == f"on each environment's own map 0 to {TRIALS - 1}"


def test_a_package_that_is_in_no_repository_has_no_commit(
    experiment: Experiment, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> str:
        raise CalledProcessError(128, "git")

    monkeypatch.setattr(module, "check_output", refuse)
    module._commit.cache_clear()
    assert made_with(experiment)["commit"] == "not in a repository"
    module._commit.cache_clear()


def test_the_table_has_a_row_for_each(experiment: Experiment) -> None:
    (block,) = provenance(experiment)
    assert dict(block.table.rows) == made_with(experiment)
