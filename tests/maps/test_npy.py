"""NumPy's files: every kind of number in both orders, and nothing that is pickled, cut off or endless."""

from __future__ import annotations

from io import BytesIO
from typing import Any

import numpy as np
import pytest
from numpy.lib import format as npy

from acoexp import MapError
from acoexp.maps.npy import parse_npy
from acoexp.maps.reading import LONGEST_SIDE

CELLS = np.array([[2, 0, 1], [0, 0, 3]])


def saved(array: Any, **options: Any) -> bytes:
    """Return an array as ``numpy.save`` writes it."""
    file = BytesIO()
    np.save(file, array, **options)
    return file.getvalue()


def headed(head: str) -> bytes:
    """Return a file with such a head, and 64 bytes after it."""
    return npy.magic(1, 0) + len(head).to_bytes(2, "little") + head.encode() + bytes(64)


def refusal(content: bytes) -> str:
    """Return the message with which a file is refused."""
    with pytest.raises(MapError) as caught:
        parse_npy(content, "yard.npy")
    return str(caught.value)


@pytest.mark.parametrize("kind", ["i1", "u1", ">i4", "<i8", "u8", "f2", "f4", ">f8", np.longdouble])
@pytest.mark.parametrize("order", ["C", "F"])
def test_any_numbers_in_any_order(kind: Any, order: Any) -> None:
    assert parse_npy(saved(np.asarray(CELLS.astype(kind), order=order)), "yard").tolist() == CELLS.tolist()


def test_true_is_an_obstacle() -> None:
    assert parse_npy(saved(CELLS == 1), "yard").tolist() == [[0, 0, 1], [0, 0, 0]]


def test_the_second_version_of_the_format_is_read_too() -> None:
    file = BytesIO()
    npy.write_array(file, CELLS, version=(2, 0))
    assert parse_npy(file.getvalue(), "yard").tolist() == CELLS.tolist()


@pytest.mark.parametrize("value", [4.0, -1.0, 0.5, np.nan, np.inf])
def test_other_values_are_told_with_their_place(value: float) -> None:
    array = np.zeros((2, 3))
    array[1, 0] = value
    assert refusal(saved(array)) == (
        f"map yard.npy: row 2, column 1: expected one of 0 1 2 3; got {array[1, 0].item()!r}"
    )


@pytest.mark.parametrize(
    ("array", "came"),
    [
        (np.array([["0", "1"]]), "shape (1, 2) of '<U1'"),
        (np.zeros((2, 2), dtype=complex), "shape (2, 2) of 'complex128'"),
        (np.zeros((2, 2), dtype="M8[s]"), "shape (2, 2) of 'datetime64[s]'"),
        (np.zeros((2, 2), dtype=[("a", "i1")]), "shape (2, 2) of \"[('a', 'i1')]\""),
        (np.zeros(4), "shape (4,) of 'float64'"),
        (np.array(0), "shape () of 'int64'"),
        (np.zeros((1, 2, 2)), "shape (1, 2, 2) of 'float64'"),
        (np.zeros((0, 2)), "shape (0, 2) of 'float64'"),
    ],
)
def test_another_array_is_refused(array: Any, came: str) -> None:
    said = "map yard.npy: expected an array [rows, cols] of bool, whole numbers or floats; got "
    assert refusal(saved(array)) == said + came


class Burglar:
    """What runs when it is unpickled."""

    def __reduce__(self) -> Any:
        return pytest.fail, ("it was unpickled",)


def test_objects_are_not_unpickled() -> None:
    array = np.array([[Burglar(), Burglar()]], dtype=object)
    assert refusal(saved(array, allow_pickle=True)).endswith("got shape (1, 2) of 'object'")


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"0 1\n0 0\n",
        b"\x93NUMPY",
        saved(CELLS)[:40],
        b"\x93NUMPY\x09\x00" + bytes(100),
        headed(""),
        headed("{'descr': '<i8'}"),
        headed("(" * 9000),
        headed("1" * 9000),
        headed("{'descr': '<i8', 'fortran_order': False, 'shape': (2, 3), }" + " " * 20_000),
        headed("{'descr': '<i8', 'fortran_order': False, 'shape': (2, 3), }")[:20],
        headed("__import__('os').system('true')"),
    ],
)
def test_what_is_no_array_is_refused(content: bytes) -> None:
    assert refusal(content).startswith("map yard.npy: expected an array as numpy.save writes it; got b")


@pytest.mark.parametrize("content", [saved(CELLS)[:-1], saved(CELLS) + b"\0", saved(CELLS) + saved(CELLS)])
def test_a_file_that_is_cut_off_or_goes_on_is_refused(content: bytes) -> None:
    assert "map yard.npy: expected 48 bytes after the head; got " in refusal(content)


@pytest.mark.parametrize("shape", [(LONGEST_SIDE + 1, 1), (10**5, 10**5), (10**4000, 2), (3000, 3000)])
def test_a_huge_array_is_refused_by_its_head(shape: tuple[int, int]) -> None:
    said = refusal(headed(f"{{'descr': '<i8', 'fortran_order': False, 'shape': {shape}, }}"))
    assert said.startswith("map yard.npy: expected at most 16384 rows and columns, and 4194304 cells; got ")
    assert len(said) < 200


@pytest.mark.parametrize("shape", ["(-2, -4)", "(-2, 4)", "(True, 8)", "(2, 4.0)", "'ab'"])
def test_a_strange_shape_is_refused(shape: str) -> None:
    refusal(headed(f"{{'descr': '<i8', 'fortran_order': False, 'shape': {shape}, }}"))
