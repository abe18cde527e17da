"""``report=sensitivity`` as a person runs it."""

from __future__ import annotations

import csv
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mlflow import MlflowClient
from running import environment, listing, refusal, run_acoexp

from acoexp import SettingsError, solve_many
from acoexp.registry.load_map import load_map
from acoexp.registry.parts import build_part
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context

KEYS = 'report.keys=["rho=interval(0.1,0.9)","beta=choice(1,12)"]'
SMALL = ("report=sensitivity", KEYS, "algo=aco", "iterations=4", "ants=2", "report.points=8", "report.trials=3")
FILES = {
    "index.html", "report.md", "report.json", "shares.csv", "curves.csv", "points.csv", "shares.svg", "curves.svg",
    ".made-by.json",
}  # fmt: skip
CONFIGURATIONS = 9 + 2 + 4 * 8  # values of rho, of beta, and the design's points


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which two keys were varied."""
    home = tmp_path_factory.mktemp("sensitivity")
    ended = run_acoexp(*SMALL, cwd=home)
    assert ended.returncode == 0, ended.stderr
    (home / "stdout").write_text(ended.stdout, encoding="utf-8")
    (home / "stderr").write_text(ended.stderr, encoding="utf-8")
    return home


@pytest.fixture(scope="module")
def folder(home: Path) -> Path:
    """The report's folder."""
    return home / "outputs/reports/sensitivity"


def rows(file: Path) -> list[dict[str, str]]:
    with file.open(encoding="utf-8", newline="") as opened:
        return list(csv.DictReader(opened))


def test_it_says_first_how_many_trials_it_runs_and_prints_the_shares(home: Path) -> None:
    trials = 11 * 3 + 4 * 8 * 4
    said = (home / "stderr").read_text("utf-8").splitlines()[0]
    assert said == f"acoexp: report=sensitivity: {trials} trials of {CONFIGURATIONS} configurations"
    printed = (home / "stdout").read_text("utf-8")
    assert re.search(r"^share of the variance +gap +cycles +found +lost", printed, re.M)
    assert re.search(r"^rho +-?\d+ % \[", printed, re.M)
    assert "report: outputs/reports/sensitivity" in printed


def test_it_leaves_a_report_and_its_batches_in_the_store(home: Path, folder: Path) -> None:
    assert listing(folder) == FILES
    client = MlflowClient(f"sqlite:///{home}/outputs/mlflow.db")
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    shared = 1  # the command line's own configuration is on both curves
    assert len(runs) == CONFIGURATIONS - shared


def test_its_numbers_are_those_of_the_trials(folder: Path) -> None:
    row = next(r for r in rows(folder / "curves.csv") if (r["key"], r["value"]) == ("beta", "1.0"))
    results = solve_many("fig13", "aco", range(3), iterations=4, ants=2, beta=1.0)
    arrived = [100.0 * (r.length / r.optimum - 1.0) for r in results if r.path is not None]
    if len(arrived) == 3:
        assert float(row["gap"]) == pytest.approx(np.mean(arrived))
    assert float(row["lost"]) == pytest.approx(100.0 * np.mean([r.lost_ants.sum() / 8 for r in results]))
    points = rows(folder / "points.csv")
    assert len(points) == 4 * 8
    first = points[0]
    results = solve_many(
        "fig13", "aco", range(3, 7), iterations=4, ants=2, beta=float(first["beta"]), rho=float(first["rho"])
    )
    assert float(first["lost"]) == pytest.approx(100.0 * np.mean([r.lost_ants.sum() / 8 for r in results]))


def test_its_json_holds_the_same_rows_and_what_they_depend_on(folder: Path) -> None:
    content = json.loads((folder / "report.json").read_text("utf-8"))
    assert [len(content[name]) for name in ("shares", "curves", "points")] == [4 * 4, 11, 32]
    assert content["keys"]["rho"] == {"span": "0.1 to 0.9", "low": 0.1, "high": 0.9}
    assert content["settings"]["ants"] == 2
    assert content["map"]["name"] == "fig13"


def test_its_page_begins_with_the_verdict_and_needs_no_other_file(folder: Path) -> None:
    page = (folder / "index.html").read_text("utf-8")
    verdict = json.loads((folder / "report.json").read_text("utf-8"))["verdict"]
    assert f"<h1>Which keys matter on fig13</h1>\n<p><strong>{verdict}</strong></p>" in page
    assert page.count("<svg") == 2
    assert page.count("<table>") == 3
    assert not re.search(r"<(img|link|script|iframe)\b|@import|url\((?!#)", page)


def test_written_again_from_the_store_it_has_the_same_bytes_and_no_further_runs(home: Path, folder: Path) -> None:
    before = {name: (folder / name).read_bytes() for name in FILES}
    database = home / "outputs/mlflow.db"
    size = database.stat().st_size
    ended = run_acoexp(*SMALL, cwd=home)
    assert ended.returncode == 0, ended.stderr
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before
    assert database.stat().st_size == size


def context(**values: Any) -> Context:
    return Context(
        algo="aco", preset=resolve("aco", {}), settings=resolve("aco", values), grid=load_map("fig13"),
        folder=Path("report"), trials_of=lambda settings, grid, seeds, show: None,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"keys": ["nope"]}, "report.keys: 'nope': expected a key that is a number of this configuration"),
        ({"keys": "rho"}, "report.keys: expected a list of texts; got 'rho'"),
        ({"points": 60}, "report.points: expected a power of two, such as 64; got 60"),
        ({"points": 4}, "report.points: expected a whole number from 8 to 8192; got 4"),
        ({"replicates": 1}, "report.replicates: expected a whole number from 2 to 1000; got 1"),
        (
            {"points": 8192, "replicates": 1000, "keys": ["rho"]},
            "report: expected at most 1000000 trials; got 24576450 by report.points=8192, report.replicates=1000",
        ),
    ],
)
def test_what_cannot_be_looked_at_is_refused(given: dict[str, Any], said: str) -> None:
    with pytest.raises(SettingsError) as caught:
        build_part("report", "sensitivity", given).check(context())
    assert str(caught.value).startswith(said)


def test_it_is_refused_before_anything_runs(tmp_path: Path) -> None:
    said = refusal("report=sensitivity", 'report.keys=["rho=interval(0.5,1.5)"]', cwd=tmp_path)
    assert said == "report.keys: rho: expected a number from 0 to 1; got 1.5"


def test_a_report_needs_neither_hydra_nor_mlflow_nor_a_picture_to_be_known() -> None:
    heavy = {"hydra", "mlflow", "matplotlib", "scipy.stats"}
    code = f"import sys, acoexp.sensitivity.report; print({heavy} & set(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment(), capture_output=True, text=True, check=True
    )
    assert done.stdout == "set()\n"
