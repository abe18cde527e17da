"""MovingAI's maps and scenarios: read as published, every published optimum is ours, what is wrong is named."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from acoexp import Grid, MapError, SettingsError
from acoexp.maps.movingai import Instance, MovingAI, parse_instance
from acoexp.parameters import build

DATA = Path(__file__).parent / "movingai"
HEAD = "type octile\nheight 3\nwidth 4\nmap\n"
YARD = HEAD + ".GSS\n@OTW\n....\n"
ROW = "7\tmaps/mine/yard.map\t4\t3\t0\t2\t3\t2\t3.00000000"


@pytest.fixture
def yard(tmp_path: Path) -> Path:
    """Return a map's file, beside a scenario for it."""
    (tmp_path / "yard.map").write_text(YARD, encoding="utf-8")
    (tmp_path / "yard.map.scen").write_text(f"version 1\n{ROW}\n{ROW.replace('7', '8', 1)}\n\n", encoding="utf-8")
    return tmp_path / "yard.map"


def load(path: Path, **options: Any) -> Grid:
    """Load a map as the command line does, its parameters checked."""
    grid: Grid = build(MovingAI, {"path": str(path), **options}, "map.").load()
    return grid


def refusal(path: Path, **options: Any) -> str:
    with pytest.raises(MapError) as caught:
        load(path, **options)
    return str(caught.value)


def test_a_map_is_what_its_letters_say(yard: Path) -> None:
    grid = load(yard, start=[0, 0], goal=[0, 3])
    assert grid.obstacles.astype(int).tolist() == [[0, 0, 0, 0], [1, 1, 1, 1], [0, 0, 0, 0]]
    assert (grid.name, grid.moves, grid.start, grid.goal) == ("yard.map", "no_cut", (0, 0), (0, 3))
    blocked = load(yard, start=[2, 0], goal=[2, 3], swamp="blocked", moves="free")
    assert blocked.obstacles[0].tolist() == [False, False, True, True]
    assert blocked.moves == "free"


def test_a_scenario_says_where_from_and_where_to_and_what_is_published(yard: Path) -> None:
    grid = load(yard, scenario=f"{yard}.scen", instance=1)
    assert (grid.name, grid.start, grid.goal) == ("yard.map#1", (2, 0), (2, 3))
    assert grid.metadata == {"bucket": 8, "published optimum": 3.0}
    assert grid.optimum == 3.0


@pytest.mark.parametrize(
    ("name", "scenario"), [("arena.map", "arena.map.scen"), ("maze-32-32-2.map", "maze-32-32-2-random-1.scen")]
)
def test_every_published_optimum_is_ours(name: str, scenario: str) -> None:
    rows = (DATA / scenario).read_text("utf-8").splitlines()[1:]
    for instance in range(0, len(rows), 1 + len(rows) // 60):
        grid = load(DATA / name, scenario=str(DATA / scenario), instance=instance)
        published = grid.metadata["published optimum"]
        assert abs(grid.optimum - published) <= 5e-6 * max(1.0, published), f"row {instance}"


@pytest.mark.parametrize(
    "text",
    [
        YARD.replace("\n", "\r\n"),
        YARD.rstrip("\n"),
        YARD + "\n\n",
        YARD.replace("height 3\nwidth 4", "width 4\nheight 3"),
    ],
)
def test_line_ends_and_the_order_of_the_head_do_not_matter(yard: Path, text: str) -> None:
    before = load(yard, start=[0, 0], goal=[0, 3]).digest
    yard.write_bytes(text.encode())
    assert load(yard, start=[0, 0], goal=[0, 3]).digest == before


@pytest.mark.parametrize(
    ("row", "map_of"),
    [
        (ROW, "yard.map"),
        (ROW.replace("\t", " "), "yard.map"),
        (ROW.replace("mine", "my own"), "yard.map"),
        (ROW.replace("maps/mine/", "maps\\mine\\").replace("\t", " ") + "\r", "yard.map"),
        (ROW.replace("maps/mine/", ""), "yard.map"),
    ],
)
def test_a_row_is_read_with_tabs_or_blanks_and_whatever_way_to_the_map(row: str, map_of: str) -> None:
    for version in ("version 1", "version 1.0"):
        found = parse_instance(f"{version}\n{row}\n", 0, "yard.map.scen")
        assert found == Instance(7, map_of, (3, 4), (2, 0), (2, 3), 3.0)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "map yard.map: expected the head of a MovingAI map: 'type octile', "),
        ("..#\n", "map yard.map: expected the head of a MovingAI map: "),
        (YARD.replace("octile", "tile"), "map yard.map: expected the head of a MovingAI map: "),
        (YARD.replace("height 3", "height -3"), "map yard.map: expected the head of a MovingAI map: "),
        (YARD.replace("height 3", "height 4"), "map yard.map: expected 4 rows of 4 cells, as its head says; got "),
        (YARD.replace("height 3", "height 999999999"), "map yard.map: expected 999999999 rows of 4 cells"),
        (
            YARD.replace("....", "..."),
            "map yard.map: expected 3 rows of 4 cells, as its head says; got 3 in row 3",
        ),
        (YARD + "....\n", "map yard.map: expected 3 rows of 4 cells, as its head says; got 4 rows"),
        (YARD.replace("....", "..x."), "map yard.map: row 3, column 3: expected one of . G S W T @ O; got 'x'"),
        (
            YARD.replace("....", "..\u00fc."),
            "map yard.map: row 3, column 3: expected one of . G S W T @ O; got '\u00fc'",
        ),
    ],
)
def test_what_is_no_map_is_named(yard: Path, text: str, said: str) -> None:
    yard.write_text(text, encoding="utf-8")
    assert refusal(yard, start=[0, 0], goal=[0, 3]).startswith(said)


@pytest.mark.parametrize(
    ("text", "instance", "said"),
    [
        ("", 0, "map.scenario: expected the first line of yard.map.scen to be 'version 1'; got ''"),
        (f"{ROW}\n", 0, "map.scenario: expected the first line of yard.map.scen"),
        (f"version 1\n{ROW}\n", 1, "map.instance: expected a row of yard.map.scen, from 0 to 0; got 1"),
        ("version 1\nx\n", 0, "map.scenario: expected nine fields in row 0 of yard.map.scen: bucket, map, "),
        (f"version 1\n{ROW.replace('3.0', 'three')}\n", 0, "map.scenario: expected nine fields in row 0"),
        (
            f"version 1\n{ROW.replace('yard', 'other')}\n",
            0,
            "map.scenario: expected one for yard.map, 4 x 3 cells; ",
        ),
        (
            f"version 1\n{ROW.replace('yard', 'a' + chr(27))}\n",
            0,
            "map.scenario: expected one for yard.map, 4 x 3 cells; yard.map.scen is for 'a\\x1b.map', 4 x 3",
        ),
        (
            f"version 1\n{ROW.replace('4', '5')}\n",
            0,
            "map.scenario: expected one for yard.map, 4 x 3 cells; yard.map.scen is",
        ),
        (
            f"version 1\n{ROW.replace('0	2	3	2', '0	1	3	2')}\n",
            0,
            "map yard.map#0: start (1, 0) is an obstacle",
        ),
    ],
)
def test_a_scenario_that_is_none_or_of_another_map_is_named(
    yard: Path, text: str, instance: int, said: str
) -> None:
    Path(f"{yard}.scen").write_text(text, encoding="utf-8")
    assert refusal(yard, scenario=f"{yard}.scen", instance=instance).startswith(said)


def test_ends_are_said_once(yard: Path) -> None:
    assert refusal(yard) == "map yard.map: expected map.start and map.goal as [row, column], or map.scenario"
    assert refusal(yard, start=[0, 0]).startswith("map yard.map: expected map.start and map.goal")
    said = refusal(yard, scenario=f"{yard}.scen", goal=[0, 1])
    assert said == "map.scenario: expected no map.start and map.goal beside it, as it has its own"


def test_files_that_are_not_there_are_named_with_their_key(yard: Path) -> None:
    assert refusal(yard.with_name("no.map"), start=[0, 0], goal=[0, 1]).startswith("map.path: expected a readable")
    assert refusal(yard, scenario=str(yard.parent)).startswith("map.scenario: expected a readable text file; got ")


@pytest.mark.parametrize("instance", [-1, 1.5, "0"])
def test_a_row_is_a_whole_number(yard: Path, instance: Any) -> None:
    with pytest.raises(SettingsError, match=r"^map\.instance: expected a whole number from 0 to "):
        load(yard, scenario=f"{yard}.scen", instance=instance)


def test_a_map_of_more_cells_than_one_may_have_is_refused(tmp_path: Path) -> None:
    (tmp_path / "large.map").write_text(f"type octile\nheight 1\nwidth 4000000\nmap\n{'.' * 4_000_000}\n")
    said = refusal(tmp_path / "large.map", start=[0, 1], goal=[0, 9])
    assert said.endswith("expected at most 16384 rows and columns, and 4194304 cells; got 1 x 4000000")


def test_a_large_map_is_read_in_no_time(tmp_path: Path) -> None:
    rows = "\n".join("".join(row) for row in np.where(np.eye(2048, dtype=bool), "T", "."))
    (tmp_path / "large.map").write_text(f"type octile\nheight 2048\nwidth 2048\nmap\n{rows}\n", encoding="utf-8")
    assert load(tmp_path / "large.map", start=[0, 1], goal=[0, 9]).shape == (2048, 2048)
