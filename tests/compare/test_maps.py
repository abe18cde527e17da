"""Maps: from texts such as a person writes, each once, or refused with the text that is at fault."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from acoexp import AcoexpError, Grid, MapError, SettingsError, load_map
from acoexp.compare.maps import MOST_MAPS, MapFacts, load_distinct, parse_maps

FOLDER = Path(__file__).parents[1] / "maps"
ARENA = FOLDER / "movingai" / "arena.map"
MAZE = FOLDER / "movingai" / "maze-32-32-2-random-1.scen"
ROBOT = FOLDER / "ros" / "testmap.yaml"


def grids(*texts: str) -> list[Grid]:
    """Return the maps that texts stand for."""
    return list(load_distinct(parse_maps(texts)))


def same(texts: list[str], *expected: Grid) -> None:
    """Check that texts stand for these maps."""
    assert [(grid.name, grid.digest) for grid in grids(*texts)] == [(one.name, one.digest) for one in expected]


def test_a_name_is_that_map() -> None:
    same(["env2", " fig13 "], load_map("env2"), load_map("fig13"))


def test_keys_are_those_of_the_command_line() -> None:
    same(["rooms map.size=[12, 14]  map.side=4"], load_map("rooms", size=(12, 14), side=4))
    same(["rooms map.side=4 map.seed=7"], load_map("rooms", side=4, seed=7))


def test_numbers_are_seeds_of_maps_by_chance() -> None:
    same(["random#0-1,5"], *(load_map("random", seed=seed) for seed in (0, 1, 5)))
    same(["maze map.size=[9,9]#3"], load_map("maze", size=(9, 9), seed=3))


def test_numbers_are_rows_of_a_scenario_whose_map_lies_beside_it() -> None:
    rows = [load_map("movingai", path=str(ARENA), scenario=f"{ARENA}.scen", instance=row) for row in (3, 4)]
    same([f"movingai:{ARENA}.scen#3-4"], *rows)
    maze = load_map("movingai", path=str(MAZE.with_name("maze-32-32-2.map")), scenario=str(MAZE), instance=9)
    same([f"{MAZE}#9"], maze)


def test_a_scenarios_map_may_lie_elsewhere(tmp_path: Path) -> None:
    scenario = tmp_path / "arena.map.scen"
    scenario.write_bytes(Path(f"{ARENA}.scen").read_bytes())
    expected = load_map("movingai", path=str(ARENA), scenario=f"{ARENA}.scen", instance=3)
    same([f"movingai:{scenario} map.path={ARENA}#3"], expected)


def test_a_file_is_read_by_the_source_that_its_ending_says(tmp_path: Path) -> None:
    drawn = tmp_path / "my map.txt"
    drawn.write_text("S..\n.#.\n..G\n", encoding="utf-8")
    same([str(drawn)], load_map("file", path=str(drawn)))
    same([f"{drawn} map.moves=four"], load_map("file", path=str(drawn), moves="four"))
    ends = "map.start=[0,3] map.goal=[9,0] map.unit=cell"
    parameters = {"start": (0.0, 3.0), "goal": (9.0, 0.0), "unit": "cell"}
    same([f"{ROBOT} {ends}"], load_map("ros", path=str(ROBOT), **parameters))
    same([f"ros:{ROBOT} {ends}"], load_map("ros", path=str(ROBOT), **parameters))


def test_maps_of_one_name_are_called_by_their_texts(tmp_path: Path) -> None:
    for name, art in (("a", "S..\n.#.\n..G\n"), ("b", "S...\n.##.\n...G\n")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "yard.txt").write_text(art, encoding="utf-8")
    first, second = grids(f"{tmp_path}/a/yard.txt", f"{tmp_path}/b/yard.txt")
    assert (first.name, second.name) == ("yard.txt", f"{tmp_path}/b/yard.txt")
    assert second.shape == (3, 4)


def test_the_same_map_twice_is_refused_by_whatever_name(tmp_path: Path) -> None:
    grid = load_map("fig13")
    rows = "\n".join("".join("#" if cell else "." for cell in row) for row in grid.obstacles)
    (tmp_path / "copy.txt").write_text(rows, encoding="utf-8")
    with pytest.raises(SettingsError, match=r"each counts once; 'fig13' and '.*copy\.txt' are the same"):
        grids("fig13", str(tmp_path / "copy.txt"))
    with pytest.raises(SettingsError, match=r"each counts once; 'random#2' and 'random map.seed=2' are the same"):
        grids("random#0-3", "random map.seed=2")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("nope", "map: expected one of: "),
        ("", "map: expected one of: "),
        ("nope.txt", "map.path: expected "),
        ("fig13#0-3", "expected no #, as map=fig13 has no key whose numbers it could give"),
        ("random#9-0", "after #: expected a range from low to high, such as 0-9; got '9-0'"),
        ("random#3,3", "after #: expected each seed once"),
        ("random#-1", "after #: expected whole numbers and ranges"),
        ("random#99999999999999999999", "after #: expected a whole number from 0 to 2^64 - 1"),
        ("random map.seed=1#0-3", "expected map.seed or #, which gives it; got both"),
        ("random map.sede=1", "map.sede is not a known key"),
        ("random map.seed=0-3", "map.seed: expected a whole number"),
        ("random seed=1", "expected keys of the map, such as map.moves=no_cut; got 'seed=1'"),
        ("random map=3", "expected keys of the map, such as map.moves=no_cut; got 'map=3'"),
        ("random map.side=3", "map.side is a key of map=rooms, not of map=random"),
        (f"movingai:{ARENA}#0-3", "expected a scenario before #, the numbers of its rows"),
        (f"{ARENA}.scen#150-160", "map.instance: expected a row of arena.map.scen, from 0 to 159; got 160"),
        ("movingai:gone.map.scen#0", "map.scenario: expected "),
        (
            "random map.density=1.0 map.size=[5,5]",
            "map random-5x5-d1-s0: expected settings under which a way leads",
        ),
        (
            f"random#0-{MOST_MAPS}",
            f"expected at most {MOST_MAPS} maps in a report; got {MOST_MAPS + 1} up to here",
        ),
        ("x" * 5000 + ".txt", "map.path: expected "),
    ],
)
def test_what_is_no_map_is_refused_in_one_line(text: str, said: str) -> None:
    with pytest.raises(AcoexpError) as caught:
        grids(text)
    assert str(caught.value).startswith("report.maps: ")
    assert f": {said}" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 900


def test_a_map_without_a_way_is_refused_by_its_text(tmp_path: Path) -> None:
    (tmp_path / "wall.txt").write_text("S#.\n##.\n..G\n", encoding="utf-8")
    with pytest.raises(MapError, match=r"report\.maps: '.*wall\.txt': map wall\.txt: no way leads from start"):
        grids(str(tmp_path / "wall.txt"))


def test_many_texts_are_too_many_as_well() -> None:
    with pytest.raises(SettingsError, match=f"expected at most {MOST_MAPS} maps"):
        parse_maps(["random#0-499", "maze#0-499", "fig13"])


def test_of_a_map_a_report_keeps_what_it_needs() -> None:
    grid = Grid(np.array([[0, 0, 0], [0, 1, 0]]), name="yard")
    assert MapFacts.of(grid) == ("yard", grid.digest, grid.optimum, 3, 5)
