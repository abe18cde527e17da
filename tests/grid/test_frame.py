"""The frame: a plain rotation about the lower left corner, there and back."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from acoexp import MapError
from acoexp.grid import Frame

NUMBERS = st.floats(-1e4, 1e4)
FRAMES = st.builds(
    Frame,
    rows=st.integers(1, 500),
    resolution=st.floats(0.01, 10.0),
    origin=st.tuples(NUMBERS, NUMBERS),
    yaw=st.floats(-7.0, 7.0),
)


def test_unturned_x_counts_columns_and_y_counts_rows_from_the_bottom() -> None:
    frame = Frame(rows=4, resolution=0.5, origin=(-1.0, 10.0))
    assert frame.to_metres([[3, 0], [0, 2]]).tolist() == [[-0.75, 10.25], [0.25, 11.75]]
    assert frame.corners(3).tolist() == [[-1.0, 10.0], [0.5, 10.0], [0.5, 12.0], [-1.0, 12.0]]


def test_turned_by_a_quarter_what_was_to_the_right_is_above() -> None:
    frame = Frame(rows=2, resolution=1.0, origin=(5.0, 5.0), yaw=math.pi / 2)
    assert np.allclose(frame.to_metres([[1, 0], [1, 2], [0, 0]]), [[4.5, 5.5], [4.5, 7.5], [3.5, 5.5]])


@given(FRAMES, st.integers(0, 499), st.integers(0, 499))
def test_a_cells_centre_is_a_rotation_of_complex_numbers(frame: Frame, row: int, col: int) -> None:
    place = complex(col + 0.5, frame.rows - row - 0.5) * frame.resolution
    expected = complex(*frame.origin) + cmath.rect(1.0, frame.yaw) * place
    assert complex(*frame.to_metres([[row, col]])[0]) == pytest.approx(expected, abs=1e-6)


@given(FRAMES, st.integers(0, 499), st.integers(0, 499), st.floats(-0.49, 0.49), st.floats(-0.49, 0.49))
def test_every_point_of_a_cell_leads_back_to_it(frame: Frame, row: int, col: int, right: float, up: float) -> None:
    turn = cmath.rect(frame.resolution, frame.yaw)
    point = complex(*frame.to_metres([[row, col]])[0]) + turn * complex(right, up)
    assert frame.to_cell(point.real, point.imag) == (row, col)


def test_a_point_far_outside_has_a_cell_far_outside() -> None:
    frame = Frame(rows=3, resolution=1e-300, origin=(-1e12, 0.0), yaw=0.7)
    for x, y in ((1.7e308, 1.7e308), (-1.7e308, 1.7e308)):
        assert max(map(abs, frame.to_cell(x, y))) >= 2**31 - 3


@pytest.mark.parametrize(
    "odd", [{"rows": 0}, {"resolution": 0.0}, {"resolution": -1.0}, {"resolution": math.nan}, {"yaw": math.inf},
            {"origin": (math.nan, 0.0)}],
)  # fmt: skip
def test_what_is_no_frame_is_refused(odd: dict[str, Any]) -> None:
    with pytest.raises(
        MapError, match=r"^frame: expected finite numbers, rows and resolution above 0; got Frame\("
    ):
        Frame(**{"rows": 3, "resolution": 1.0, **odd})
