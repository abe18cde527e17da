"""``report=compare`` as a person runs it."""

from __future__ import annotations

import csv
import json
import re
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import numpy as np
import pytest
from mlflow import MlflowClient
from PIL import Image
from running import environment, listing, refusal, run_acoexp

from acoexp import solve_many
from acoexp.console.whole import whole_folder
from acoexp.strategies.groups import STRATEGY_GROUPS

CELLS = 'report.cells=[aco,"pd ants=3"]'
NAMED = 'report.cells=["plain: aco","more: pd"]'
SMALL = ("report=compare", "iterations=4", "ants=2", "report.trials=3")
FILES = {
    "index.html",
    "report.md",
    "tables.tex",
    "cells.csv",
    "pairs.csv",
    "report.json",
    "curves.svg",
    "curves.png",
}


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which two cells were compared on two maps."""
    home = tmp_path_factory.mktemp("compare")
    ended = run_acoexp(CELLS, "report.maps=[fig13,env2]", *SMALL, cwd=home)
    assert ended.returncode == 0, ended.stderr
    (home / "stdout").write_text(ended.stdout, encoding="utf-8")
    return home


@pytest.fixture(scope="module")
def folder(home: Path) -> Path:
    """The report's folder."""
    return home / "outputs/reports/compare"


def test_it_leaves_a_report_and_its_batches_in_the_store(home: Path, folder: Path) -> None:
    assert listing(folder) == FILES
    assert listing(folder.parent) == {"compare", *(f"compare/{name}" for name in FILES)}
    client = MlflowClient(f"sqlite:///{home}/outputs/mlflow.db")
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    assert sorted((run.data.params["map.name"], run.data.params["ants"]) for run in runs) == [
        ("env2", "2"), ("env2", "3"), ("fig13", "2"), ("fig13", "3"),
    ]  # fmt: skip
    assert {(run.data.params["seeds"], run.data.metrics["trials"]) for run in runs} == {("0-2", 3.0)}


def test_written_again_it_takes_its_trials_from_the_store_and_is_the_same(home: Path, folder: Path) -> None:
    before = {name: (folder / name).read_bytes() for name in FILES - {"curves.png", "curves.svg", "index.html"}}
    ended = run_acoexp(CELLS, "report.maps=[fig13,env2]", *SMALL, cwd=home)
    assert ended.stderr.count("3 of 3 trials found in the store") == 4
    assert {name: (folder / name).read_bytes() for name in before} == before


def test_it_prints_a_short_table_and_where_the_report_lies(home: Path) -> None:
    printed = (home / "stdout").read_text("utf-8")
    assert re.search(r"^env2 +pd ants=3 +\d/3 ", printed, re.M)
    assert "report: outputs/reports/compare" in printed


def test_its_numbers_are_those_of_the_trials(folder: Path) -> None:
    with (folder / "cells.csv").open(encoding="utf-8") as file:
        row = next(r for r in csv.DictReader(file) if (r["map"], r["cell"]) == ("env2", "pd ants=3"))
    results = solve_many("env2", "pd", range(3), iterations=4, ants=3)
    assert float(row["lost_ants"]) == pytest.approx(np.mean([r.lost_ants.sum() for r in results]))
    assert int(row["found"]) == sum(r.found_optimum for r in results)


def test_its_json_holds_the_same_rows_and_what_they_depend_on(folder: Path) -> None:
    content = json.loads((folder / "report.json").read_text("utf-8"))
    assert [row["map"] for row in content["cells"]] == ["fig13", "fig13", "env2", "env2"]
    assert len(content["pairs"]) == 2 * 3
    assert content["configurations"]["aco"]["ants"] == 2
    assert content["configurations"]["pd ants=3"]["ants"] == 3
    assert content["configurations"]["pd ants=3"]["diffusion"]["name"] == "gaussian"


def test_it_tells_of_which_packages_the_parts_are(folder: Path) -> None:
    packages = json.loads((folder / "report.json").read_text("utf-8"))["packages"]
    assert list(packages) == ["aco", "pd ants=3"]
    assert packages["aco"] == dict.fromkeys(STRATEGY_GROUPS, f"acoexp {version('acoexp')}")


def test_it_warns_where_efforts_differ(folder: Path) -> None:
    said = "Warning: the configurations differ in ants (aco: 2, pd ants=3: 3), so their efforts differ too."
    assert said in (folder / "report.md").read_text("utf-8")
    assert said in (folder / "index.html").read_text("utf-8")


def test_cells_with_names_are_called_by_them_and_those_of_one_effort_are_not_warned_of(tmp_path: Path) -> None:
    ended = run_acoexp(NAMED, *SMALL, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert re.search(r"^fig13 +more +\d/3 ", ended.stdout, re.M)
    report = (tmp_path / "outputs/reports/compare/report.md").read_text("utf-8")
    assert "plain is aco. more is pd." in report
    assert "Warning" not in report


def test_its_page_needs_no_other_file(folder: Path) -> None:
    page = (folder / "index.html").read_text("utf-8")
    assert page.count("<table>") == 3
    assert page.count("<svg") == 1
    assert not re.search(r"<(img|link|script|iframe)\b|@import|url\((?!#)", page)


def test_its_picture_has_a_panel_per_map(folder: Path) -> None:
    with Image.open(folder / "curves.png") as picture:
        assert picture.height > picture.width


def test_the_same_command_writes_the_same_bytes_in_place_of_what_was_there(home: Path, folder: Path) -> None:
    before = {name: (folder / name).read_bytes() for name in FILES}
    (folder / "old").touch()
    assert run_acoexp(CELLS, "report.maps=[fig13,env2]", *SMALL, cwd=home).returncode == 0
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_a_report_that_fails_half_way_leaves_the_one_before(tmp_path: Path) -> None:
    with whole_folder(tmp_path / "report") as draft:
        (draft / "index.html").write_text("first", encoding="utf-8")
    with pytest.raises(FileNotFoundError), whole_folder(tmp_path / "report") as draft:
        (draft / "not there" / "index.html").write_text("second", encoding="utf-8")
    assert listing(tmp_path) == {"report", "report/index.html"}
    assert (tmp_path / "report/index.html").read_text("utf-8") == "first"


def test_jobs_of_a_sweep_write_a_report_each(tmp_path: Path) -> None:
    ended = run_acoexp(CELLS, *SMALL, "-m", "rho=0.1,0.2", "hydra.sweep.dir=here", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    reports = [json.loads(file.read_text("utf-8")) for file in sorted(tmp_path.glob("here/*/compare/report.json"))]
    assert [report["configurations"]["aco"]["rho"] for report in reports] == [0.1, 0.2]
    assert [list(report["maps"]) for report in reports] == [["fig13"], ["fig13"]]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ('report.cells=[aco,"pd gama=1"]', "report.cells: 'pd gama=1': gama is not a known key; "),
        ("report.cells=aco", "report.cells: expected a list of texts; got 'aco'"),
        ("report.cells=[aco]", "report.cells: expected two or more, each different; got ['aco']"),
        ("report.maps=[nope]", "report.maps: 'nope': map: expected one of: "),
        ("report.maps=[file]", "report.maps: 'file': map.path: expected a text; got nothing"),
        ("report.trials=1", "report.trials: expected a whole number from 2 to 100000; got 1"),
        ("diffusion.gamma=0.02", "diffusion: expected within report.cells, such as "),
        ("+report.nope=1", "report.nope is not a known key; expected one of: report.cells, report.maps, "),
    ],
)
def test_what_cannot_be_compared_is_refused_before_anything_runs(given: str, said: str, tmp_path: Path) -> None:
    assert refusal("report=compare", given, cwd=tmp_path).startswith(said)


def test_a_report_needs_neither_hydra_nor_mlflow() -> None:
    code = (
        "import sys, acoexp.compare.report, acoexp.compare.curves; print({'hydra', 'mlflow'} & set(sys.modules))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment(), capture_output=True, text=True, check=True
    )
    assert done.stdout == "set()\n"
