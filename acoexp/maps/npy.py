"""NumPy's files: one array of 0 and 1, as ``numpy.save`` writes it. Nothing that is pickled is loaded."""

from __future__ import annotations

import warnings
from io import BytesIO

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from acoexp.errors import MapError, shown
from acoexp.maps.cells import GOAL
from acoexp.maps.reading import MOST_CELLS, check_size

LARGEST_ARRAY = 8 * MOST_CELLS + 2**14
"""Bytes that such a file may have: whole numbers of eight bytes each, and a head."""

_HEADS = {(1, 0): npy.read_array_header_1_0, (2, 0): npy.read_array_header_2_0}


def parse_npy(content: bytes, name: str) -> NDArray[np.uint8]:
    """Return the cells of an array in NumPy's format, uint8[rows, cols], each 0 to 3.

    Args:
        content: The file's bytes: an array [rows, cols] of bool, whole numbers or floats, in either order.
        name: The map's name, for messages.

    Raises:
        MapError: if it is none, is cut off, or holds other values.
    """
    array = _array(content, name)
    known = np.isin(array, range(GOAL + 1))
    if not known.all():
        row, col = divmod(int(known.argmin()), known.shape[1])
        raise MapError(
            f"map {name}: row {row + 1}, column {col + 1}: expected one of 0 1 2 3; got "
            f"{shown(array[row, col].item())}"
        )
    return array.astype(np.uint8)


def _array(content: bytes, name: str) -> NDArray[np.generic]:
    file = BytesIO(content)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of heads that Python 2 may have written
            shape, fortran, dtype = _HEADS[npy.read_magic(file)](file)
    except Exception as problem:  # whatever reading a damaged head leads to
        raise MapError(
            f"map {name}: expected an array as numpy.save writes it; got {shown(content[:40])}"
        ) from problem
    if dtype.kind not in "biuf" or len(shape) != 2 or not all(type(n) is int and n > 0 for n in shape):
        raise MapError(
            f"map {name}: expected an array [rows, cols] of bool, whole numbers or floats; got shape "
            f"{shown(shape)} of {shown(str(dtype))}"
        )
    check_size(*shape, name)
    left = len(content) - file.tell()
    if left != shape[0] * shape[1] * dtype.itemsize:
        raise MapError(
            f"map {name}: expected {shape[0] * shape[1] * dtype.itemsize} bytes after the head; got {left}: "
            "the file is cut off, or has more than one array"
        )
    return np.frombuffer(content, dtype, offset=file.tell()).reshape(shape, order="F" if fortran else "C")
