"""Maps as text: art, digits and separators, marks, remarks, and what is said of a text that is no map."""

from __future__ import annotations

from time import perf_counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import grids

from acoexp import Grid, MapError
from acoexp.maps import parse_map
from acoexp.maps.reading import LONGEST_SIDE, MOST_CELLS

ART = "..#\n...\n#..\n"
DIGITS = "0 0 1\n0 0 0\n1 0 0\n"
OBSTACLES = [[0, 0, 1], [0, 0, 0], [1, 0, 0]]


def refusal(text: str, **options: object) -> str:
    """Return the message with which a text is refused."""
    with pytest.raises(MapError) as caught:
        parse_map(text, name="yard.txt", **options)  # type: ignore[arg-type]
    return str(caught.value)


@pytest.mark.parametrize(
    "text",
    [ART, DIGITS, "001\n000\n100", ". . #\n. . .\n# . .", "0\t0\t1\n0\t0\t0\n1\t0\t0", " 0 0 1\n0  0 0\n1 0 0 "],
)
def test_a_map_is_ascii_art_or_digits_with_or_without_blanks(text: str) -> None:
    assert parse_map(text, name="yard").obstacles.tolist() == OBSTACLES


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("art", [ART, DIGITS])
def test_any_line_ends_do(art: str, end: str) -> None:
    assert parse_map(art.replace("\n", end), name="yard").obstacles.tolist() == OBSTACLES


@pytest.mark.parametrize("text", ["\n\n" + ART, ART + "\n\n", ART + "  \n\t\n", ART.strip()])
def test_blank_lines_around_a_map_do_not_matter(text: str) -> None:
    assert parse_map(text, name="yard").shape == (3, 3)


def test_s_and_g_mark_start_and_goal_on_free_cells() -> None:
    grid = parse_map("..#\nG.S\n", name="yard")
    assert (grid.start, grid.goal) == ((1, 2), (1, 0))
    assert grid.obstacles.sum() == 1


def test_without_marks_and_arguments_the_ends_are_the_corners() -> None:
    grid = parse_map(ART, name="yard")
    assert (grid.start, grid.goal) == ((0, 0), (2, 2))


def test_arguments_say_what_the_text_does_not_mark() -> None:
    grid = parse_map("S.#\n...\n", name="yard", goal=(1, 0))
    assert (grid.start, grid.goal) == ((0, 0), (1, 0))


def test_an_argument_may_repeat_a_mark_but_not_contradict_it() -> None:
    assert parse_map("S.\n..", name="yard", start=(0, 0)).start == (0, 0)
    message = refusal("S.\n..", start=(0, 1))
    assert message == "map yard.txt: S stands at (0, 0), but start (0, 1) was given; drop one"


@pytest.mark.parametrize(("text", "mark"), [("SS\n..", "S"), ("G.\nG.", "G")])
def test_a_mark_stands_once(text: str, mark: str) -> None:
    assert f"map yard.txt: {mark} marks the " in refusal(text)
    assert "expected it once, got it 2 times" in refusal(text)


@pytest.mark.parametrize(
    "text",
    [
        "0,0,1\n0,0,0\n1,0,0\n",
        "0;0;1\n0;0;0\n1;0;0\n",
        "0, 0, 1\n0, 0, 0\n1, 0, 0\n",
        "0,0,1,\n0,0,0,\n1,0,0,\n",
        "0 0 1;\n0 0 0;\n1 0 0;\n",
        "0.0,0.0,1.0\n-0.0,+0,0.\n1.000e+00,0e5,0.0\n",
        "# a yard, by hand\n% and so on\n0,0,1\n0,0,0\n# the hedge\n1,0,0\n",
    ],
)
def test_digits_may_stand_between_separators_and_be_written_as_numbers(text: str) -> None:
    assert parse_map(text, name="yard").obstacles.tolist() == OBSTACLES


@pytest.mark.parametrize("text", ["0 2 1\n3 0 0\n", "021\n300\n", "0,2.0,1\n3.0,0,0\n", "0;S;1\nG;0;0\n"])
def test_2_and_3_mark_start_and_goal_among_digits(text: str) -> None:
    grid = parse_map(text, name="yard")
    assert (grid.start, grid.goal, grid.obstacles.sum()) == ((0, 1), (1, 0), 1)


def test_a_mark_among_digits_stands_once_too() -> None:
    assert refusal("2 0 S\n").startswith("map yard.txt: 2 or S marks the start; expected it once, got it 2 times")
    assert refusal("0 3\n0 0\n", goal=(1, 1)).startswith("map yard.txt: 3 or G stands at (0, 1), but goal (1, 1)")


def test_art_of_obstacles_alone_in_a_line_is_no_remark() -> None:
    assert parse_map("####\n#..#\n####\n", name="yard", start=(1, 1), goal=(1, 2)).shape == (3, 4)


def test_a_matrix_in_brackets_has_metadata_above_it_and_rows_after_semicolons_in_it() -> None:
    grid = parse_map("; moves: free\nmap = [0 0 1\n; 0 0 0\n; 1 0 0];\n", name="yard")
    assert (grid.obstacles.tolist(), grid.moves) == (OBSTACLES, "free")


def test_remarks_are_skipped_wherever_they_stand() -> None:
    assert parse_map("; a yard\n..#\n;\n...\n; hedge below\n#..\n", name="yard").obstacles.tolist() == OBSTACLES


def test_remarks_with_a_key_are_metadata() -> None:
    grid = parse_map("; origin: drawn: by hand\n;size:3\n; no key\n" + ART, name="yard")
    assert grid.metadata == {"origin": "drawn: by hand", "size": "3"}
    assert grid.name == "yard"


@pytest.mark.parametrize("rule", ["free", "no_squeeze", "no_cut", "four"])
def test_a_text_declares_its_rule_for_diagonals(rule: str) -> None:
    assert parse_map(f"; moves: {rule}\n" + ART, name="yard").moves == rule


def test_an_argument_overrides_the_declared_rule() -> None:
    assert parse_map("; moves: free\n" + ART, name="yard", moves="no_cut").moves == "no_cut"
    assert parse_map(ART, name="yard").moves == "no_squeeze"


def test_an_unknown_declared_rule_is_refused() -> None:
    message = refusal("; moves: sideways\n" + ART)
    assert "expected one of: free, no_squeeze, no_cut, four; got 'sideways'" in message


@pytest.mark.parametrize("text", ["", "\n\n", "; moves: free\n", "   \n"])
def test_a_text_without_rows_is_refused(text: str) -> None:
    assert refusal(text) == "map yard.txt: expected rows of '.' and '#' or of 0 and 1; got an empty text"


@pytest.mark.parametrize("text", ["...\n..\n", "0 0 0\n0 0\n"])
def test_a_ragged_text_is_refused(text: str) -> None:
    assert refusal(text) == "map yard.txt: row 2 has 2 cells; expected 3, as in row 1"


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("..\n.x\n", "row 2, column 2: expected one of . # S G; got 'x'"),
        ("..\ns.\n", "row 2, column 1: expected one of . # S G; got 's'"),
        ("..\n.0\n", "row 2, column 2: expected one of . # S G; got '0'"),
        ("0 0\n0 4\n", "row 2, column 2: expected one of 0 1 2 3 S G; got '4'"),
        ("0 0\n0 #\n", "row 2, column 2: expected one of 0 1 2 3 S G; got '#'"),
        ("01 10\n00 00\n", "row 1, column 1: expected one of 0 1 2 3 S G; got '01'"),
        ("0.0,0.5\n0.0,0.0\n", "row 1, column 2: expected one of 0 1 2 3 S G; got '0.5'"),
        ("0,,1\n0,0,0\n", "row 1, column 2: expected one of 0 1 2 3 S G; got ''"),
        ("0,0 1\n0,0\n", "row 1, column 2: expected one of 0 1 2 3 S G; got '0 1'"),
        ("0 0 0\n# 0 0\n0 0 0\n", "row 2, column 1: expected one of 0 1 2 3 S G; got '#'"),
        ("0,-1\n0,0\n", "row 1, column 2: expected one of 0 1 2 3 S G; got '-1'"),
        ("0,nan\n0,0\n", "row 1, column 2: expected one of 0 1 2 3 S G; got 'nan'"),
        ("0,0_0\n0,0\n", "row 1, column 2: expected one of 0 1 2 3 S G; got '0_0'"),
    ],
)
def test_other_symbols_are_refused_with_their_place(text: str, complaint: str) -> None:
    assert refusal(text) == f"map yard.txt: {complaint}"


def test_what_is_wrong_with_the_map_itself_names_the_map() -> None:
    assert "map yard.txt: no way leads" in refusal(".#.\n.#.\n")
    assert "map yard.txt: start (0, 0) is an obstacle" in refusal("#..\n...\n")
    assert "map yard.txt: goal (7, 7) lies outside" in refusal(ART, goal=(7, 7))


def as_text(grid: Grid, free: str, wall: str, blank: str) -> str:
    """Write a grid down, its rule as a remark."""
    rows = [blank.join(wall if cell else free for cell in row) for row in grid.obstacles.tolist()]
    return "\n".join([f"; moves: {grid.moves}", *rows])


@settings(deadline=None)
@given(grids(8), st.sampled_from([(".", "#", ""), (".", "#", " "), ("0", "1", ""), ("0", "1", " ")]))
def test_what_is_written_down_is_read_back(grid: Grid, style: tuple[str, str, str]) -> None:
    again = parse_map(as_text(grid, *style), name=grid.name, start=grid.start, goal=grid.goal)
    assert again.digest == grid.digest


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("." * (LONGEST_SIDE + 1), f"1 x {LONGEST_SIDE + 1}"),
        ("0,0\n" * (LONGEST_SIDE + 1), f"{LONGEST_SIDE + 1} x 2"),
    ],
)
def test_a_map_of_more_rows_or_columns_than_one_may_have_is_refused(text: str, size: str) -> None:
    assert refusal(text).endswith(f"at most {LONGEST_SIDE} rows and columns, and {MOST_CELLS} cells; got {size}")


@pytest.mark.parametrize("style", [(".", "#", ""), ("0", "1", " "), ("0.0", "1.0", ","), ("0", "1", ", ")])
def test_a_large_map_is_read_in_no_time(style: tuple[str, str, str], monkeypatch: pytest.MonkeyPatch) -> None:
    """Without its optimum, which costs the same for all formats; half as fast as it must be is too slow."""
    monkeypatch.setattr("acoexp.maps.cells.Grid", lambda obstacles, **_: obstacles)
    cells = np.eye(1024, dtype=bool)
    text = as_text(Grid(cells, start=(0, 1), goal=(0, 2)), *style)
    begin = perf_counter()
    assert np.array_equal(parse_map(text, name="yard"), cells)  # type: ignore[arg-type]
    assert perf_counter() - begin < 1.0
