"""IOHprofiler's format: read back by a reader of its description, and by iohinspector where it is there."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from compared import LOST, sample

from acoexp.compare.configuration import Configuration, parse_configurations
from acoexp.compare.export.ioh import export_trials, runs_of
from acoexp.compare.maps import MapFacts
from acoexp.compare.sample import Sample

MAPS = [MapFacts("yard", "1e5", 10.0, 8, 40), MapFacts("a/../b: $x$ é", "f00d", 20.0, 300, 5000)]
COMPARED: list[Configuration] = parse_configurations(["aco ants=5", "my/own: pd ants=1"], {})
CURVES = [[12.0, 11.0, 11.0, 10.0, 10.0], [LOST, 13.0, 12.0, 14.0, 12.5], [LOST] * 5]
STEPS = [[3, 4, 5, 6, 7]] * 3


def made(optimum: float) -> list[Sample]:
    """Return trials of both configurations on a map."""
    scaled = [[length * optimum / 10.0 for length in curve] for curve in CURVES]
    return [sample(scaled, one.label, "", optimum, STEPS) for one in COMPARED]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the trials of two configurations on two maps."""
    folder = tmp_path_factory.mktemp("trials") / "ioh"
    export_trials(folder, COMPARED, MAPS, [made(facts.optimum) for facts in MAPS])
    return folder


def read(file: Path) -> list[list[list[float]]]:
    """Return the runs of a ``.dat``: each begins with a line of names, then a line for each record."""
    runs: list[list[list[float]]] = []
    for line in file.read_text("utf-8").splitlines():
        if line == "evaluations raw_y ant_steps":
            runs.append([])
        else:
            runs[-1].append([float(word) for word in line.split(" ")])
    return runs


def described(folder: Path) -> list[tuple[dict[str, Any], list[list[list[float]]]]]:
    """Return what each JSON says, with its runs."""
    found = []
    for file in sorted(folder.rglob("IOHprofiler_f*.json")):
        about = json.loads(file.read_text("utf-8"))
        (scenario,) = about["scenarios"]
        found.append((about, read(file.parent / scenario["path"])))
    return found


def test_each_configuration_has_a_file_for_each_map_and_nothing_lies_elsewhere(folder: Path) -> None:
    assert sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()) == [
        f"{name}/{file}"
        for name in ("1-aco_ants_5", "2-my_own")
        for file in (
            "IOHprofiler_f1_yard.json",
            "IOHprofiler_f2_a_.._b_x.json",
            "data_f1_yard/IOHprofiler_f1_DIM8.dat",
            "data_f2_a_.._b_x/IOHprofiler_f2_DIM300.dat",
        )
    ]
    assert listing_is_inside(folder)


def listing_is_inside(folder: Path) -> bool:
    """Tell whether all that was written lies in the folder."""
    return [path.name for path in folder.parent.iterdir()] == [folder.name]


def test_names_are_as_they_are_within_the_files(folder: Path) -> None:
    about = [one for one, _ in described(folder)]
    assert [(one["algorithm"]["name"], one["function_name"], one["function_id"]) for one in about] == [
        ("aco ants=5", "yard", 1), ("aco ants=5", "a/../b: $x$ é", 2),
        ("my/own", "yard", 1), ("my/own", "a/../b: $x$ é", 2),
    ]  # fmt: skip
    assert about[2]["algorithm"]["info"] == "pd ants=1"


def test_a_run_has_a_line_where_it_gets_better_and_one_at_its_end(folder: Path) -> None:
    _, (better, late, lost) = described(folder)[0]
    worst = pytest.approx(40 * math.sqrt(2.0) / 10.0 - 1.0)
    assert better == [[1, worst, 0], [5, 0.2, 3], [10, 0.1, 7], [20, 0.0, 18], [25, 0.0, 25]]
    assert late == [[1, worst, 0], [10, 0.3, 7], [15, 0.2, 12], [25, 0.2, 25]]
    assert lost == [[1, worst, 0], [25, worst, 25]]


def test_where_one_ant_walks_its_first_walk_is_the_first_evaluation(folder: Path) -> None:
    _, (better, late, _) = described(folder)[2]
    assert better[0] == [1, 0.2, 3]
    assert [line[0] for line in late] == [1, 2, 3, 5]


def test_the_json_says_of_each_run_what_its_lines_do(folder: Path) -> None:
    for about, runs in described(folder):
        (scenario,) = about["scenarios"]
        assert about["maximization"] is False
        assert [run["seed"] for run in scenario["runs"]] == [0, 1, 2]
        for run, lines in zip(scenario["runs"], runs, strict=True):
            assert run["evals"] == lines[-1][0]
            best = min(line[1] for line in lines)
            assert run["best"]["y"] == pytest.approx(best, abs=1e-9)
            assert run["best"]["evals"] == next(line[0] for line in lines if line[1] == best)


def test_no_line_is_worse_than_the_one_before() -> None:
    draw = np.random.default_rng(3)
    lengths = 10.0 + draw.integers(0, 20, (30, 12))
    for run in runs_of(sample(lengths.tolist()), 7, 9.0):
        assert (np.diff(run.lines[:, 0]) > 0).all()
        assert (np.diff(run.lines[:, 1]) <= 0).all()
        assert (np.diff(run.lines[:-1, 1]) < 0).all()


@pytest.mark.filterwarnings("error")
def test_iohinspector_reads_the_same(folder: Path) -> None:
    iohinspector = pytest.importorskip("iohinspector")
    manager = iohinspector.DataManager()
    manager.add_folder(str(folder))
    assert manager.n_runs == 2 * 2 * 3
    table = manager.load(monotonic=False, include_meta_data=True).to_dicts()
    for about, runs in described(folder):
        keys = (about["algorithm"]["name"], about["function_id"])
        for number, lines in enumerate(runs, 1):
            theirs = [
                [row["evaluations"], row["raw_y"], row["ant_steps"]]
                for row in table
                if (row["algorithm_name"], row["function_id"]) == keys and row["run_id"] == number
            ]
            assert theirs == lines
