"""The folder of a sweep: named absolutely, one sweep's at a time, with the jobs of earlier ones left alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from omegaconf import DictConfig, OmegaConf

from acoexp.command.sweep.plan import first_number, fix_folder, only_sweep_in
from acoexp.errors import SettingsError

Composed = Callable[..., DictConfig]


@pytest.mark.parametrize("name", ["plain", "it's swept", "with, comma", "a b"])
def test_the_folder_is_absolute_for_every_job_that_is_composed_later(
    name: str, composed: Composed, tmp_path: Path
) -> None:
    config = OmegaConf.create({"hydra": {"sweep": {"dir": name}, "overrides": {"hydra": []}}})
    assert fix_folder(config) == tmp_path / name
    assert composed(*config.hydra.overrides.hydra).hydra.sweep.dir == str(tmp_path / name)


def test_jobs_are_numbered_on_from_those_that_are_in_the_folder(tmp_path: Path) -> None:
    assert first_number(tmp_path) == 0
    for name in ("0", "9", "10", "maps", ".submitit", "x11"):
        (tmp_path / name).mkdir()
    (tmp_path / "99").touch()
    assert first_number(tmp_path) == 11


def test_a_folder_is_one_sweeps_at_a_time(tmp_path: Path) -> None:
    said = r"^hydra\.sweep\.dir: expected a folder in which no other sweep runs"
    with only_sweep_in(tmp_path / "study"):
        with pytest.raises(SettingsError, match=said), only_sweep_in(tmp_path / "study"):
            pass
        with only_sweep_in(tmp_path / "another"):
            pass
    with only_sweep_in(tmp_path / "study"):
        assert [*(tmp_path / "study").iterdir()] == []
