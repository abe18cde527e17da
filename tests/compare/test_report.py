"""``report=compare`` as a person runs it."""

from __future__ import annotations

import csv
import json
import re
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mlflow import MlflowClient
from PIL import Image
from running import environment, listing, refusal, run_acoexp

from acoexp import SettingsError, solve_many
from acoexp.registry.load_map import load_map
from acoexp.registry.parts import build_part
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context
from acoexp.strategies.groups import STRATEGY_GROUPS
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

CELLS = 'report.cells=[aco,"pd ants=3"]'
SMALL = ("report=compare", "iterations=4", "ants=2", "report.trials=3")
FILES = {
    "index.html",
    "report.md",
    "tables.tex",
    "cells.csv",
    "pairs.csv",
    "values.csv",
    "ranks.csv",
    "effects.csv",
    "budgets.csv",
    "report.json",
    *(
        f"{name}.{ending}"
        for name in ("curves", "effects", "profiles", "targets", "budgets")
        for ending in ("svg", "png")
    ),
    ".made-by.json",
}


def context(folder: Path) -> Context:
    """Return what a report works on, without a store."""
    settings = resolve("pdg", {"iterations": 4, "ants": 2})
    return Context(
        algo="pdg",
        preset=resolve("pdg", {}),
        settings=settings,
        grid=load_map("fig13"),
        folder=folder,
        trials_of=lambda settings, grid, seeds, show: Trials.of(Solver(grid, settings).solve_many(seeds)),
    )


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which two configurations were compared on two maps."""
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


def test_configurations_with_names_are_called_by_them_and_those_of_one_effort_are_not_warned_of(
    tmp_path: Path,
) -> None:
    report = build_part("report", "compare", {"cells": ["plain: aco", "more: pd"], "trials": 3})
    written = report.write(context(tmp_path / "compare"))
    assert [row[:2] for row in report.headline(written)[1:]] == [["fig13", "plain"], ["fig13", "more"]]
    page = (written / "report.md").read_text("utf-8")
    assert "plain is aco. more is pd." in page
    assert "Warning" not in page


def test_its_page_needs_no_other_file(folder: Path) -> None:
    page = (folder / "index.html").read_text("utf-8")
    assert page.count("<table>") == 5
    assert page.count("<svg") == 5
    assert not re.search(r"<(img|link|script|iframe)\b|@import|url\((?!#)", page)


def test_its_picture_has_a_panel_per_map(folder: Path) -> None:
    with Image.open(folder / "curves.png") as picture:
        assert picture.height > picture.width


def test_written_again_from_the_store_it_has_the_same_bytes_and_nothing_else(home: Path, folder: Path) -> None:
    before = {name: (folder / name).read_bytes() for name in FILES}
    (folder / "old").touch()
    ended = run_acoexp(CELLS, "report.maps=[fig13,env2]", *SMALL, cwd=home)
    assert ended.stderr.count("3 of 3 trials found in the store") == 4
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_on_another_map_it_keeps_the_one_that_was_there(tmp_path: Path) -> None:
    yard = tmp_path / "yard.txt"
    command = (*SMALL, CELLS, "map=file", "map.path=yard.txt", "tracking=none")
    for art in ("S..\n.#.\n..G\n", "S...\n.##.\n...G\n"):
        yard.write_text(art, encoding="utf-8")
        ended = run_acoexp(*command, cwd=tmp_path)
        assert ended.returncode == 0, ended.stderr
    reports = tmp_path / "outputs/reports"
    (kept,) = (path for path in reports.iterdir() if path.name != "compare")
    assert re.fullmatch(r"compare-\d{4}(-\d\d){5}", kept.name)
    assert f"or was changed since, and is kept: outputs/reports/{kept.name}\n" in ended.stderr
    assert all((reports / name / "index.html").is_file() for name in ("compare", kept.name))


def test_names_are_on_the_screen_and_in_the_picture_as_they_are(tmp_path: Path) -> None:
    (tmp_path / "$^$ [b].txt").write_text("S..\n.#.\n..G\n", encoding="utf-8")
    yard = ("map=file", 'map.path="$^$ [b].txt"', "tracking=none")
    ended = run_acoexp(*SMALL, 'report.cells=["[b]x: aco","_y: pd"]', *yard, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert re.search(r"^\$\^\$ \[b\]\.txt \[b\]x +\d/3 ", ended.stdout, re.M)
    svg = (tmp_path / "outputs/reports/compare/curves.svg").read_text("utf-8")
    for text in ("$^$ [b].txt, optimum 3.4142", "[b]x", "_y", "exact optimum"):
        assert svg.count(f"<!-- {text} -->") == 1, text


def test_jobs_of_a_sweep_write_a_report_each(tmp_path: Path) -> None:
    ended = run_acoexp(CELLS, *SMALL, "-m", "rho=0.1,0.2", "hydra.sweep.dir=here", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    reports = [json.loads(file.read_text("utf-8")) for file in sorted(tmp_path.glob("here/*/compare/report.json"))]
    assert [report["configurations"]["aco"]["rho"] for report in reports] == [0.1, 0.2]
    assert [list(report["maps"]) for report in reports] == [["fig13"], ["fig13"]]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"cells": ["aco", "pd gama=1"]}, "report.cells: 'pd gama=1': gama is not a known key; "),
        ({"cells": "aco"}, "report.cells: expected a list of texts; got 'aco'"),
        ({"cells": ["aco"]}, "report.cells: expected two or more, each different; got ['aco']"),
        ({"maps": ["nope"]}, "report.maps: 'nope': map: expected one of: "),
        ({"maps": ["file"]}, "report.maps: 'file': map.path: expected a text; got nothing"),
        ({"maps": ["fig13", "fig13"]}, "report.maps: expected different maps, as each counts once; "),
        (
            {"maps": ["random#0-1000"]},
            "report.maps: 'random#0-1000': expected at most 1000 maps in a report; got 1001",
        ),
        ({"maps": ["random#0-499"], "trials": 100_000}, "report.trials: expected at most 100000000 cycles of all"),
        ({"export": "coco"}, "report.export: expected one of: none, ioh; got 'coco'"),
        ({"trials": 1}, "report.trials: expected a whole number from 2 to 100000; got 1"),
        ({"nope": 1}, "report.nope is not a known key; expected one of: report.cells, report.maps, "),
    ],
)
def test_what_cannot_be_compared_is_refused(given: dict[str, Any], said: str, tmp_path: Path) -> None:
    with pytest.raises(SettingsError) as caught:
        build_part("report", "compare", given).check(context(tmp_path))
    assert str(caught.value).startswith(said)


@pytest.fixture(scope="module")
def verdict(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a report on maps of several kinds, with its trials in IOHprofiler's format."""
    home = tmp_path_factory.mktemp("verdict")
    scenario = Path(__file__).parents[1] / "maps" / "movingai" / "arena.map.scen"
    maps = f"report.maps=[fig13,'random map.size=[12,12]#0-11',\"movingai:{scenario}#150-151\"]"
    ended = run_acoexp(CELLS, maps, *SMALL, "report.export=ioh", "tracking=none", cwd=home)
    assert ended.returncode == 0, ended.stderr
    (home / "stdout").write_text(ended.stdout, encoding="utf-8")
    return home / "outputs/reports/compare"


def test_over_many_maps_it_prints_ranks(verdict: Path) -> None:
    printed = (verdict.parents[2] / "stdout").read_text("utf-8")
    assert re.search(r"^cell +mean rank +best on", printed, re.M)
    assert re.search(r"^pd ants=3 +[12]\.\d\d +\d+/15", printed, re.M)
    assert json.loads((verdict / "report.json").read_text("utf-8"))["verdict"]["text"].startswith("Over 15 maps: ")


def test_its_steps_and_lengths_are_those_of_the_trials(verdict: Path) -> None:
    grid = load_map("random", size=(12, 12), seed=4)
    results = solve_many(grid, "pd", range(3), iterations=4, ants=3)
    data = verdict / "ioh" / "2-pd_ants_3" / f"data_f6_{grid.name}" / "IOHprofiler_f6_DIM12.dat"
    runs = [
        [line.split() for line in run.splitlines()] for run in data.read_text("utf-8").split("evaluations")[1:]
    ]
    for lines, result in zip(runs, results, strict=True):
        walks, gap, steps = map(float, lines[-1])
        assert (walks, steps) == (12, result.ant_steps)
        if result.path is not None:
            assert gap == pytest.approx(result.length / grid.optimum - 1.0, abs=1e-9)


def test_with_trials_from_a_store_it_has_the_same_steps(home: Path, folder: Path) -> None:
    before = (folder / "budgets.csv").read_bytes()
    ended = run_acoexp(CELLS, "report.maps=[fig13,env2]", *SMALL, "tracking=none", cwd=home)
    assert ended.returncode == 0, ended.stderr
    assert (folder / "budgets.csv").read_bytes() == before


def test_a_part_on_the_command_line_is_refused_before_anything_runs(tmp_path: Path) -> None:
    said = refusal("report=compare", "diffusion.gamma=0.02", cwd=tmp_path)
    assert said.startswith("diffusion: expected within report.cells, such as ")


def test_a_report_needs_neither_hydra_nor_mlflow() -> None:
    code = (
        "import sys, acoexp.compare.report, acoexp.compare.curves; print({'hydra', 'mlflow'} & set(sys.modules))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment(), capture_output=True, text=True, check=True
    )
    assert done.stdout == "set()\n"
