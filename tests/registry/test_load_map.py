"""Loading a map: whatever a person says one by becomes a grid, or is refused in terms of what was said."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from acoexp import Grid, MapError, SettingsError, StrategyError
from acoexp.registry.load_map import as_grid, load_map

YARD = Grid([[0, 1, 0], [0, 0, 0]], name="yard")
ART = "; moves: free\n..#\n...\n"


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a map's file."""
    path = tmp_path_factory.mktemp("maps") / "garden.txt"
    path.write_text(ART, encoding="utf-8")
    return path


def test_a_sources_name_and_parameters_are_a_map(file: Path) -> None:
    assert load_map("fig13", moves="no_cut").moves == "no_cut"
    assert load_map("file", path=str(file), goal=[1, 0]).goal == (1, 0)


@pytest.mark.parametrize(
    ("name", "parameters", "said"),
    [
        ("fig12", {}, r"^map: expected one of: env1, env2, fig13, file.*; got 'fig12'"),
        (None, {}, r"^map: expected one of: .*; got None"),
        ("fig13", {"path": "x"}, "^map.path is a key of map=file and .*, not of map=fig13"),
        ("fig13", {"nope": "x"}, "^map.nope is not a known key; expected one of: map.moves"),
        ("file", {}, "^map.path: expected a text; got nothing"),
    ],
)
def test_a_source_that_there_is_not_or_that_lacks_something_is_refused(
    name: Any, parameters: dict[str, Any], said: str
) -> None:
    with pytest.raises(SettingsError, match=said):
        load_map(name, **parameters)


def test_a_grid_stands_for_itself() -> None:
    assert as_grid(YARD) is YARD


def test_a_name_stands_for_its_source_with_nothing_else_said() -> None:
    assert as_grid("env2").digest == load_map("env2").digest


def test_a_path_stands_for_a_file_with_ends_and_rule_if_they_are_given(file: Path) -> None:
    grid = as_grid(file)
    assert (grid.name, grid.start, grid.goal, grid.moves) == ("garden.txt", (0, 0), (1, 2), "free")
    grid = as_grid(file, (1, 0), (0, 1), "no_cut")
    assert (grid.start, grid.goal, grid.moves) == ((1, 0), (0, 1), "no_cut")


@pytest.mark.parametrize("array", [YARD.obstacles, YARD.obstacles.astype(int).tolist()])
def test_an_array_stands_for_a_map_under_the_usual_rule(array: Any) -> None:
    assert as_grid(array).digest == YARD.digest
    assert as_grid(array).moves == "no_squeeze"
    other = as_grid(array, start=(1, 0), moves="free")
    assert (other.start, other.goal, other.moves) == ((1, 0), (1, 2), "free")


@pytest.mark.parametrize("own", ["env2", YARD])
@pytest.mark.parametrize("given", [{"start": (0, 0)}, {"goal": (0, 0)}, {"moves": "free"}])
def test_what_has_ends_and_a_rule_of_its_own_takes_no_others(own: Any, given: dict[str, Any]) -> None:
    with pytest.raises(SettingsError, match=r"^start, goal and moves: expected only with a map given as an array"):
        as_grid(own, **given)


def test_a_map_without_a_way_is_refused() -> None:
    with pytest.raises(MapError, match="no way leads from start"):
        as_grid(np.array([[0, 1, 0]]))


SOURCES = """
from dataclasses import dataclass
from acoexp.maps.source import MapSource

@dataclass(frozen=True, kw_only=True)
class Torn(MapSource):
    def load(self):
        return 1 / 0

@dataclass(frozen=True, kw_only=True)
class Ending(MapSource):
    def load(self):
        raise SystemExit(3)

@dataclass(frozen=True, kw_only=True)
class Empty(MapSource):
    def load(self):
        return [[0, 0]]
"""
ENTRIES = "[acoexp.map]\ntorn = wild_maps:Torn\nending = wild_maps:Ending\nempty = wild_maps:Empty\n"


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("torn", r" failed in load: ZeroDivisionError: division by zero; \S+wild_maps.py:8: return 1 / 0$"),
        ("ending", r" failed in load: SystemExit: 3; \S+wild_maps.py:13: raise SystemExit\(3\)$"),
        ("empty", ": expected load to return a Grid; got list$"),
    ],
)
def test_a_source_that_fails_is_named_with_its_package_and_its_authors_line(
    name: str, said: str, install_package: Callable[..., None]
) -> None:
    install_package("wild-maps", ENTRIES, {"wild_maps.py": SOURCES})
    with pytest.raises(StrategyError, match=f"^map '{name}' of package wild-maps 1.0{said}"):
        load_map(name)
    sys.modules.pop("wild_maps", None)
