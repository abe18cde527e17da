"""``report=watch`` as a person runs it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from running import listing, refusal, run_acoexp

from acoexp import solve
from acoexp.watch.page import data_of

pytestmark = pytest.mark.slow_without_jit

SMALL = ("report=watch", "map=env2", "iterations=6", "tracking=none")


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which two colonies are to be watched."""
    home = tmp_path_factory.mktemp("watch")
    ended = run_acoexp('report.cells=[aco,"mine: pdg ants=4"]', "seed=3", *SMALL, cwd=home)
    assert ended.returncode == 0, ended.stderr
    (home / "stdout").write_text(ended.stdout, encoding="utf-8")
    return home


@pytest.fixture
def page(home: Path, show: Callable[..., Any]) -> Any:
    return show(home / "outputs/reports/watch/index.html")


def test_it_leaves_one_page_and_says_what_the_trials_found(home: Path) -> None:
    assert listing(home / "outputs/reports/watch") == {"index.html", ".made-by.json"}
    rows = [line.split() for line in (home / "stdout").read_text(encoding="utf-8").splitlines()]
    results = [solve("env2", "aco", seed=3, iterations=6), solve("env2", "pdg", seed=3, iterations=6, ants=4)]
    assert rows[:3] == [
        ["cell", "l1", "x1", "lost"],
        *(
            [name, f"{result.l1:.4f}", str(result.x1), str(result.lost_ants.sum())]
            for name, result in zip(["aco", "mine"], results, strict=True)
        ),
    ]


def test_both_are_shown_side_by_side_with_the_seed_of_the_command_line(page: Any) -> None:
    boxes = [board.bounding_box() for board in page.locator(".board").all()]
    assert len(boxes) == 2
    assert boxes[0]["y"] == boxes[1]["y"]
    assert page.locator(".board h2").all_text_contents()[1].strip() == "mine"
    for place, (algo, ants) in enumerate([("aco", 10), ("pdg", 4)]):
        path = solve("env2", algo, seed=3, iterations=6, ants=ants).path
        assert path is not None
        assert page.evaluate(f"acoexp.colonies[{place}].path()") == path.tolist()


def test_without_cells_it_is_the_command_lines_own_colony(tmp_path: Path) -> None:
    ended = run_acoexp(*SMALL, "algo=pdg", "post=none", "seed=5", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    (colony,) = data_of((tmp_path / "outputs/reports/watch/index.html").read_text(encoding="utf-8"))["colonies"]
    assert (colony["name"], colony["seed"], colony["cycles"]) == ("custom", "5", 6)
    assert colony["bests"][-1]["length"] == solve("env2", "pdg", seed=5, iterations=6, post="none").l1


def test_another_seeds_page_is_kept(tmp_path: Path) -> None:
    for seed in (1, 2, 2):
        assert run_acoexp(*SMALL, "algo=aco", f"seed={seed}", cwd=tmp_path).returncode == 0
    assert len(list((tmp_path / "outputs/reports").iterdir())) == 2


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("report.cells=[aco,pd,pdg,pf,eas]", "report.cells: expected two to 4 to watch; got 5"),
        ("report.cells=[aco]", "report.cells: expected two or more, each different; got ['aco']"),
        ("report.cells=[aco,aco]", "report.cells: expected two or more, each different; got ['aco', 'aco']"),
        ('report.cells=["a: aco","a: pd"]', "report.cells: expected two or more, each different; got ['a', 'a']"),
        ("report.cells=[aco,nobody]", "report.cells: 'nobody': algo"),
        ("seeds='0-9'", "seeds: expected none with a report"),
        ("iterations=1000000", "iterations: expected at most"),
    ],
)
def test_what_cannot_be_watched_is_refused(given: str, message: str, tmp_path: Path) -> None:
    settings = [key for key in SMALL if not key.startswith(given.partition("=")[0])]
    assert message in refusal(*settings, given, cwd=tmp_path)


def test_parts_that_no_cell_would_use_are_refused(tmp_path: Path) -> None:
    message = refusal(*SMALL, "report.cells=[aco,pd]", "post=none", cwd=tmp_path)
    assert message.startswith("post: expected within report.cells, such as ")
