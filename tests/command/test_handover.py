"""The handover: what a worker gets of its parent, wherever it runs, and what jobs of a sweep share."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hydra.core.singleton import Singleton

from acoexp import Grid
from acoexp.command.handover import Handover
from acoexp.command.results.records import BATCH, TRIAL
from acoexp.errors import SettingsError
from acoexp.grid import Frame
from acoexp.maps import parse_map

CONFIG = {"name": "file", "path": "yard.txt", "moves": None}
YARD = parse_map("; moves: no_cut\n; origin: drawn by hand\n..S\n.#.\nG..\n", name="yard.txt")


def everything(grid: Grid | None) -> dict[str, Any]:
    """Return all that a map is."""
    assert grid is not None
    names = ("digest", "name", "start", "goal", "moves", "metadata", "frame", "optimum_pair")
    return {name: getattr(grid, name) for name in names}


def test_a_map_that_was_put_is_found_again_with_all_that_it_says_of_itself(
    handover: Handover, tmp_path: Path
) -> None:
    handover.put_maps(tmp_path, [(CONFIG, YARD), ({**CONFIG, "path": "other"}, Grid([[0, 0]], name="other"))])
    assert everything(handover.map_of(CONFIG)) == everything(YARD)
    frame = Frame(rows=1, resolution=0.05, origin=(-10.0, 2.5), yaw=0.3)
    handover.put_maps(tmp_path, [(CONFIG, YARD), ({}, Grid([[0, 0]], frame=frame))])
    assert everything(handover.map_of({}))["frame"] == frame
    assert handover.map_of(dict(reversed(CONFIG.items()))) is handover.map_of(CONFIG)


@pytest.mark.parametrize("other", [{**CONFIG, "path": "garden.txt"}, {**CONFIG, "moves": "free"}, {}])
def test_a_map_that_was_not_put_is_none(handover: Handover, other: dict[str, Any], tmp_path: Path) -> None:
    assert handover.map_of(other) is None
    handover.put_maps(tmp_path, [(CONFIG, YARD)])
    assert handover.map_of(other) is None


def test_jobs_of_a_process_share_a_map(handover: Handover, tmp_path: Path) -> None:
    handover.put_maps(tmp_path, [(CONFIG, YARD)])
    assert handover.map_of(CONFIG) is handover.map_of(CONFIG)


def test_a_map_that_takes_anothers_place_is_the_one_that_is_found(handover: Handover, tmp_path: Path) -> None:
    for grid in (YARD, Grid([[0, 0, 0]], name="later")):
        handover.put_maps(tmp_path, [(CONFIG, grid)])
        assert everything(handover.map_of(CONFIG)) == everything(grid)


def test_a_map_that_would_run_code_is_not_loaded(handover: Handover, tmp_path: Path) -> None:
    handover.put_maps(tmp_path, [(CONFIG, YARD)])
    (file,) = (tmp_path / "maps").iterdir()
    about = b'{"start": [0, 0], "goal": [0, 1], "moves": "free", "name": "yard", "metadata": {}}'
    np.savez(file, obstacles=np.array([[print]], dtype=object), about=np.frombuffer(about, np.uint8))
    with pytest.raises(ValueError, match="allow_pickle"):
        handover.map_of(CONFIG)


def test_hydra_takes_it_to_its_workers(handover: Handover, tmp_path: Path) -> None:
    handover.put_maps(tmp_path, [(CONFIG, YARD)])
    handover.addresses["sqlite:///x.db"] = f"sqlite:///{tmp_path}/x.db"
    taken = pickle.loads(pickle.dumps(Singleton.get_state()["instances"][Handover]))
    assert (taken.home, taken.addresses) == (handover.home, handover.addresses)
    assert everything(taken.map_of(CONFIG)) == everything(YARD)


def test_all_of_a_process_have_the_same(handover: Handover) -> None:
    assert Handover() is handover


def test_a_job_runs_in_the_parents_folder_if_it_is_there(
    tmp_path: Path, handover: Handover, monkeypatch: pytest.MonkeyPatch
) -> None:
    home, elsewhere = tmp_path / "home", tmp_path / "elsewhere"
    home.mkdir()
    elsewhere.mkdir()
    handover.home = home
    monkeypatch.chdir(elsewhere)
    with handover.in_parent_folder():
        assert Path.cwd() == home
    home.rmdir()
    with handover.in_parent_folder():
        assert Path.cwd() == elsewhere


def test_outside_of_a_sweep_a_jobs_folder_is_its_own(handover: Handover, tmp_path: Path) -> None:
    assert handover.own_folder(tmp_path / "job") == tmp_path / "job"


def test_jobs_that_a_pattern_leads_to_one_folder_have_one_each_within_it(
    handover: Handover, tmp_path: Path
) -> None:
    handover.put_maps(tmp_path, [])
    job, other = tmp_path / "job", tmp_path / "other"
    assert [handover.own_folder(job) for _ in range(3)] == [job, job / "2", job / "3"]
    assert handover.own_folder(other) == other
    assert (job / "3").is_dir()


def test_what_an_earlier_sweep_left_in_such_a_folder_stays(handover: Handover, tmp_path: Path) -> None:
    job = tmp_path / "job"
    for record, expected in ((TRIAL, job), (BATCH, job / "2"), (TRIAL, job / "3")):
        handover.put_maps(tmp_path, [])
        assert handover.own_folder(job) == expected
        (expected / record).touch()


@pytest.mark.parametrize("folder", ["../beside", "/elsewhere", "linked/job"])
def test_a_folder_outside_of_the_sweeps_is_refused(handover: Handover, folder: str, tmp_path: Path) -> None:
    sweep = tmp_path / "sweep"
    handover.put_maps(sweep, [])
    (sweep / "linked").symlink_to(tmp_path)
    with pytest.raises(SettingsError, match=r"^hydra\.sweep\.subdir: expected a folder within "):
        handover.own_folder(sweep / folder)
    assert not (tmp_path / "beside").exists()


def test_a_sweep_that_uses_a_folder_again_begins_with_the_folder_itself(
    handover: Handover, tmp_path: Path
) -> None:
    for _ in range(2):
        handover.put_maps(tmp_path, [])
        assert handover.own_folder(tmp_path / "job") == tmp_path / "job"
