"""Matrices in brackets, as MATLAB, Python and NumPy write them, and what is said of what is none."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from samples import grids

from acoexp import Grid, MapError
from acoexp.maps import parse_map

OBSTACLES = [[0, 0, 1], [0, 0, 0], [1, 0, 0]]


def refusal(text: str) -> str:
    """Return the message with which a text is refused."""
    with pytest.raises(MapError) as caught:
        parse_map(text, name="yard.m")
    return str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        "map = [0 0 1; 0 0 0; 1 0 0];",
        "[0,0,1;0,0,0;1,0,0]",
        "G=[0 0 1\n0 0 0\n1 0 0\n];\n",
        "% the yard [3 x 3]\nmap = [ ...\n  0, 0, 1;  % the hedge\n\n  0, 0, 0;\n  1, 0, 0;\n];  % done\n",
        "map = [0 0 ... and on\n 1; 0 ...\n 0 0; 1 0 0]",
        "map = logical([0 0 1; 0 0 0; 1 0 0]);",
        "map = [0.0 0.00 1.0; 0 0 0; 1e0 0 0]",
        "map\t=\r\n[0\t0\t1;\r\n0\t0\t0;\r\n1\t0\t0]\r\n",
    ],
)
def test_a_matrix_as_matlab_has_it(text: str) -> None:
    assert parse_map(text, name="yard").obstacles.tolist() == OBSTACLES


@pytest.mark.parametrize(
    "text",
    [
        "[[0, 0, 1], [0, 0, 0], [1, 0, 0]]",
        "grid = [\n    [0, 0, 1],  # the hedge\n    [0, 0, 0],\n    [1, 0, 0],\n]\n",
        "grid = np.array([[0, 0, 1],\n                 [0, 0, 0],\n                 [1, 0, 0]])",
        "self.map = numpy.array([[0, 0, 1], [0, 0, 0], [1, 0, 0]], dtype=np.uint8)",
        "[[0, 0,\n 1], [0, 0, 0,], [1, 0, 0]]",
        "[[0 0 1]\n [0 0 0]\n [1 0 0]]",
        "[[False, False, True], [False, False, False], [True, False, False]]",
        json.dumps(OBSTACLES, indent=2),
        str(np.array(OBSTACLES, dtype=float)),
        repr(np.array(OBSTACLES, dtype=bool)),
    ],
)
def test_a_list_of_lists_as_python_has_it(text: str) -> None:
    assert parse_map(text, name="yard").obstacles.tolist() == OBSTACLES


@pytest.mark.parametrize("text", ["[0 2 1; 3 0 0]", "[[0, 2, 1], [3, 0, 0]]", "[0 S 1; G 0 0]"])
def test_2_and_3_mark_start_and_goal(text: str) -> None:
    grid = parse_map(text, name="yard")
    assert (grid.start, grid.goal, grid.obstacles.sum()) == ((0, 1), (1, 0), 1)


@pytest.mark.parametrize(
    "text",
    [
        "[0 0 1",
        "0 0 1]\n[",
        "a = [0 0]; b = [0 1]",
        "clear all\nmap = [0 0; 0 0]",
        "map = [0 0; 0 0]'",
        "np.array([0 0; 0 0]",
        "[0 0; 0 0])",
        "[[0, 0], 0]",
        "[[[0, 0]], [[0, 0]]]",
        "[[0, 0]; [0, 0]]",
        "[[0, 0], , [0, 0]]",
        "[[0 0 0]\n ...\n [0 0 0]]",
        "[]",
        "[;]",
        "[" * 100_000,
        "[" + "[" * 100_000 + "]" * 100_001,
        "a" * 100_000 + "[0 0]",
        "[0 0]" + " " * 100_000 + "x",
    ],
)
def test_what_is_not_one_matrix_is_refused(text: str) -> None:
    message = refusal(text)
    assert message.startswith("map yard.m: expected one matrix and nothing else, such as [0 1; 0 0] or ")
    assert len(message) < 400


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("[0 0; 0 4]", "row 2, column 2: expected one of 0 1 2 3 S G; got '4'"),
        ("[0 0; 0 0.5]", "row 2, column 2: expected one of 0 1 2 3 S G; got '0.5'"),
        ("[010; 000]", "row 1, column 1: expected one of 0 1 2 3 S G; got '010'"),
        ("[[0, 0],\n [x, 0]]", "row 2, column 1: expected one of 0 1 2 3 S G; got 'x'"),
        ("[[0, , 0], [0, 0, 0]]", "row 1, column 2: expected one of 0 1 2 3 S G; got ''"),
        ("[[0 0 ... 0]\n [0 0 ... 0]]", "row 1, column 3: expected one of 0 1 2 3 S G; got '...'"),
        ("[[0, 0], []]", "row 2 has 0 cells; expected 2, as in row 1"),
        ("[0 0; 0]", "row 2 has 1 cells; expected 2, as in row 1"),
        ("[[], []]", "expected an array [rows, cols] of 0 and 1; got shape (2, 0)"),
    ],
)
def test_what_is_wrong_in_a_matrix_is_told_with_its_place(text: str, complaint: str) -> None:
    assert refusal(text) == f"map yard.m: {complaint}"


def written(grid: Grid, style: str) -> str:
    """Write a grid's obstacles down as a program of the field would."""
    rows = grid.obstacles.astype(int).tolist()
    if style == "matlab":
        return "map = [" + "; ...\n".join(" ".join(map(str, row)) for row in rows) + "];"
    return f"grid = np.array({str(rows).replace('],', f'],{chr(10)}')})" if style == "numpy" else json.dumps(rows)


@given(grids(8), st.sampled_from(["matlab", "numpy", "json"]))
def test_what_is_written_down_is_read_back(grid: Grid, style: str) -> None:
    again = parse_map(written(grid, style), name="yard", start=grid.start, goal=grid.goal, moves=grid.moves)
    assert again.digest == grid.digest
