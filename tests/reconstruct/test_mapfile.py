"""A found map's file: a map like any other, and one to go on from."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from acoexp import Grid, SettingsError
from acoexp.maps.text import parse_map
from acoexp.reconstruct.fit import Fit
from acoexp.reconstruct.layout import paint
from acoexp.reconstruct.mapfile import map_text, read_layout
from acoexp.reconstruct.published import ENVIRONMENTS

LAYOUT = np.array([[11, 9, 17, 18], [2, 2, 9, 12]])
MOVES = "no_cut"
OPTIMUM = Grid(paint(LAYOUT), moves=MOVES).optimum_pair
ENVIRONMENT = replace(ENVIRONMENTS["env1"], optimum=OPTIMUM)
FIT = Fit(trials=8, l1={"30.3848": 5}, l2={"30.3848": 3}, x1=9.0, x3=20.5, score=-1.25)
TEXT = map_text(LAYOUT, MOVES, ENVIRONMENT, FIT, "python -m acoexp.reconstruct seed=7")


def test_it_is_a_map_file_of_the_painted_rectangles_under_the_rule_of_the_search() -> None:
    grid = parse_map(TEXT, name="found")
    assert (grid.obstacles == paint(LAYOUT)).all()
    assert grid.moves == MOVES


@pytest.mark.parametrize(
    ("key", "said"),
    [
        ("optimum", f"{OPTIMUM[0]} straight, {OPTIMUM[1]} diagonal"),
        ("rectangles", "2 2 9 12, 11 9 17 18"),
        ("trials", "8"),
        ("l1", "30.3848 5"),
        ("l2", "30.3848 3"),
        ("score", "-1.25"),
        ("command", "python -m acoexp.reconstruct seed=7"),
    ],
)
def test_it_says_where_it_comes_from_and_how_it_fits(key: str, said: str) -> None:
    assert parse_map(TEXT, name="found").metadata[key] == said


def test_a_search_can_go_on_from_its_rectangles_under_its_rule(tmp_path: Path) -> None:
    file = tmp_path / "found.txt"
    file.write_text(TEXT, encoding="utf-8")
    layout, moves = read_layout(str(file), ENVIRONMENT)
    assert sorted(layout.tolist()) == sorted(LAYOUT.tolist())
    assert moves == MOVES


def test_a_map_with_another_optimum_is_none_to_go_on_from(tmp_path: Path) -> None:
    file = tmp_path / "found.txt"
    file.write_text(TEXT, encoding="utf-8")
    with pytest.raises(SettingsError, match="begin: expected a 20 x 20 map with the optimum of env2; got"):
        read_layout(str(file), ENVIRONMENTS["env2"])
