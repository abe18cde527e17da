"""One trial without ``-m``: its files, its pictures, and what is printed."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import NamedTuple

import pytest
import yaml
from PIL import Image
from running import QUICK, listing, run_acoexp, trials

from acoexp import solve

ARGS = ("seed=7", "map=env1", *QUICK)


class Run(NamedTuple):
    """What a run left behind."""

    ended: subprocess.CompletedProcess[str]
    home: Path
    folder: Path


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Run one trial."""
    home = tmp_path_factory.mktemp("run")
    ended = run_acoexp(*ARGS, cwd=home)
    assert ended.returncode == 0, ended.stderr
    (folder,) = home.glob("outputs/runs/*/*")
    return Run(ended, home, folder)


def test_its_folder_holds_record_configuration_and_pictures(run: Run) -> None:
    names = {name for name in listing(run.folder) if not name.startswith(".hydra")}
    names.discard("acoexp.log")  # there if the kernels had to be compiled
    assert names == {"trial.json", "config.yaml", "path.csv", "path.png", "convergence.png"}


@pytest.mark.parametrize("name", ["path.png", "convergence.png"])
def test_a_picture_is_a_png_with_something_on_it(run: Run, name: str) -> None:
    with Image.open(run.folder / name) as picture:
        assert picture.format == "PNG"
        assert min(picture.size) >= 300
        colours = picture.convert("RGB").getcolors(maxcolors=1 << 24)
    assert len(colours) > 10


def test_its_record_is_what_python_finds_for_the_same_seed(run: Run) -> None:
    (trial,) = trials(run.folder)
    result = solve("env1", algo="pdg", seed=7, iterations=3, ants=2)
    assert {key: trial[key] for key in result.as_dict()} == yaml.safe_load(
        yaml.safe_dump(as_lists(result.as_dict()))
    )
    assert trial["seconds"] > 0.0


def as_lists(values: dict[str, object]) -> dict[str, object]:
    """Return values with lists for tuples, as JSON has them."""
    return {key: list(value) if isinstance(value, tuple) else value for key, value in values.items()}


@pytest.mark.parametrize("shown", [["--cfg", "job"], ["--cfg", "all"], ["--info", "config"]], ids=" ".join)
def test_what_is_shown_of_a_configuration_has_no_password(shown: list[str], tmp_path: Path) -> None:
    ended = run_acoexp("tracking.uri='http://me:s3cr%40et%2Fhunter2@server:5000'", *shown, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert "server:5000" in ended.stdout
    assert "hunter2" not in ended.stdout + ended.stderr


def test_its_configuration_is_what_cfg_shows(run: Run) -> None:
    shown = run_acoexp("--cfg", "job", *ARGS, cwd=run.home)
    assert yaml.safe_load((run.folder / "config.yaml").read_text("utf-8")) == yaml.safe_load(shown.stdout)


def test_it_prints_what_it_found_and_where_it_lies(run: Run) -> None:
    (trial,) = trials(run.folder)
    (row,) = (line.split() for line in run.ended.stdout.splitlines() if line.startswith("pdg"))
    assert row[1] == "env1"
    assert (f"{trial['l1']:.4f}" if trial["l1"] else "-") in row
    assert f"{trial['optimum']:.4f}" in row
    assert run.ended.stdout.splitlines()[-3:] == [
        f"files: {run.folder.relative_to(run.home)}",
        "pictures follow, then where it is kept",
        "run:   not tracked",
    ]


def test_it_works_where_a_relative_path_of_a_map_leads(tmp_path: Path) -> None:
    (tmp_path / "my yard.txt").write_text("S.#\n..#\n..G\n", encoding="utf-8")
    ended = run_acoexp("map=file", "map.path='my yard.txt'", *QUICK, "hydra.run.dir=here", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    (trial,) = trials(tmp_path / "here")
    assert trial["map"] == "my yard.txt"
    assert trial["optimum_pair"] == [0, 2]


def test_a_job_may_work_in_its_own_folder(tmp_path: Path) -> None:
    """Hydra's hydra.job.chdir moves the process, but not the store: that is under the working directory."""
    ended = run_acoexp("iterations=3", "ants=2", "hydra.job.chdir=true", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert [path.relative_to(tmp_path) for path in tmp_path.rglob("mlflow.db")] == [Path("outputs/mlflow.db")]


def test_output_that_can_show_ascii_only_harms_nothing(tmp_path: Path) -> None:
    ended = run_acoexp("-m", "seed=0,1", *QUICK, cwd=tmp_path, env={"PYTHONIOENCODING": "ascii"})
    assert ended.returncode == 0, ended.stderr
    assert "2 of 2 trials finished" in ended.stdout


def test_a_folder_that_was_used_before_lends_its_trials_to_nobody(tmp_path: Path) -> None:
    again = (*QUICK, "hydra.sweep.dir=again", "-m")
    assert "2 of 2 trials" in run_acoexp("seed=0,1", *again, cwd=tmp_path).stdout
    assert "1 of 1 trials" in run_acoexp("seed=5", "hydra.sweep.subdir=fifth/x", *again, cwd=tmp_path).stdout


def test_each_store_that_a_sweep_names_is_prepared(tmp_path: Path) -> None:
    ended = run_acoexp("-m", "tracking=mlflow,none", "iterations=3", "ants=2", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert "mlflow.db, not tracked" in ended.stdout
