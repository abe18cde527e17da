"""Parameters: declared once, checked wherever a value comes in, and refused in words."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from acoexp import SettingsError
from acoexp.parameters import REQUIRED, build, defaults_of, fields_of, parameter

HUGE = pytest.param(10**400, id="huge")


@dataclass(frozen=True, kw_only=True)
class Sample:
    """One parameter of every kind."""

    share: float = parameter(0.5, "a share", minimum=0.0, maximum=1.0)
    reach: float = parameter(4.0, "a distance in cells", above=0.0)
    gain: float = parameter(1.0, "a gain", minimum=0.0)
    shift: float = parameter(0.0, "any number")
    ants: int = parameter(10, "how many", minimum=1, maximum=100)
    loud: bool = parameter(False, "yes or no")
    mode: str = parameter("sum", "which way", choices=("sum", "nearest"))
    rule: str | None = parameter(None, "which rule, if any", choices=("free", "no_cut"))
    cell: tuple[int, int] | None = parameter(None, "a cell, if any")
    point: tuple[float, float] | None = parameter(None, "a point in metres, if any")
    maps: tuple[str, ...] = parameter(("a", "b"), "some names")


@dataclass(frozen=True, kw_only=True)
class Needy:
    """A parameter without a default."""

    path: str = parameter(REQUIRED, "a file")


@dataclass(frozen=True)
class Bare:
    """No parameters at all."""


def refusal(values: dict[str, Any], owner: type = Sample, prefix: str = "") -> str:
    """Return the message with which values are refused."""
    with pytest.raises(SettingsError) as caught:
        build(owner, values, prefix)
    return str(caught.value)


def test_parameters_are_listed_in_order_of_declaration() -> None:
    names = ["share", "reach", "gain", "shift", "ants", "loud", "mode", "rule", "cell", "point", "maps"]
    assert list(fields_of(Sample)) == list(defaults_of(Sample)) == names
    assert defaults_of(Sample)["share"] == 0.5
    assert fields_of(Sample)["share"].metadata["meaning"] == "a share"
    assert fields_of(Bare) == {}


def test_what_is_not_said_takes_its_default() -> None:
    assert build(Sample, {}) == Sample()
    assert build(Sample, {"ants": 3}) == Sample(ants=3)


@pytest.mark.parametrize(
    ("key", "value", "becomes"),
    [
        ("share", 0, 0.0), ("share", 1, 1.0), ("share", np.float32(0.25), 0.25), ("share", np.int8(1), 1.0),
        ("share", np.longdouble("0.5"), 0.5),
        ("reach", 1e-9, 1e-9), ("shift", -1e9, -1e9), ("shift", np.float64(2.5), 2.5),
        ("ants", 1, 1), ("ants", np.int64(100), 100), ("ants", np.uint8(7), 7),
        ("loud", True, True), ("mode", "nearest", "nearest"), ("rule", None, None), ("rule", "free", "free"),
        ("cell", None, None), ("cell", [1, 2], (1, 2)), ("cell", (np.int64(1), 2), (1, 2)),
        ("cell", np.array([1, 2]), (1, 2)), ("point", [-1.5, 2], (-1.5, 2.0)), ("point", np.ones(2), (1.0, 1.0)),
        ("maps", ["x", "y z"], ("x", "y z")), ("maps", [], ()),
    ],
)  # fmt: skip
def test_values_become_what_is_declared(key: str, value: Any, becomes: Any) -> None:
    stored = getattr(build(Sample, {key: value}), key)
    assert stored == becomes
    assert type(stored) is type(becomes)


@pytest.mark.parametrize(
    ("key", "value", "expected"),
    [
        ("share", -0.1, "a number from 0 to 1"),
        ("share", 1.5, "a number from 0 to 1"),
        ("share", "0.5", "a number from 0 to 1"),
        ("share", True, "a number from 0 to 1"),
        ("share", float("nan"), "a number from 0 to 1"),
        ("share", [0.5], "a number from 0 to 1"),
        ("reach", 0, "a number above 0"),
        ("reach", float("inf"), "a number above 0"),
        ("gain", -1, "a number, at least 0"),
        ("shift", np.nan, "a number"),
        ("shift", 1j, "a number"),
        ("ants", 0, "a whole number from 1 to 100"),
        ("ants", 101, "a whole number from 1 to 100"),
        ("ants", 5.0, "a whole number from 1 to 100"),
        ("ants", np.float64(5), "a whole number from 1 to 100"),
        ("ants", True, "a whole number from 1 to 100"),
        ("ants", np.True_, "a whole number from 1 to 100"),
        ("loud", 1, "true or false"),
        ("loud", "true", "true or false"),
        ("mode", "mean", "one of: sum, nearest"),
        ("mode", 5, "one of: sum, nearest"),
        ("rule", "sum", "one of: free, no_cut"),
        ("cell", [1], "a pair [row, column]"),
        ("cell", [1, 2.0], "a pair [row, column]"),
        ("cell", [1, True], "a pair [row, column]"),
        ("cell", "12", "a pair [row, column]"),
        ("cell", 12, "a pair [row, column]"),
        ("point", [1.0], "a pair [x, y]"),
        ("point", [1.0, float("nan")], "a pair [x, y]"),
        ("point", [1.0, float("inf")], "a pair [x, y]"),
        ("point", [True, 1.0], "a pair [x, y]"),
        ("maps", "x", "a list of texts"),
        ("maps", ["x", 1], "a list of texts"),
    ],
)
def test_other_values_are_refused_with_what_was_expected_and_what_came(
    key: str, value: Any, expected: str
) -> None:
    assert refusal({key: value}) == f"{key}: expected {expected}; got {value!r}"


@pytest.mark.parametrize("key", ["share", "ants", "loud", "mode"])
def test_nothing_is_not_a_value(key: str) -> None:
    assert refusal({key: None}).endswith("; got nothing")
    assert refusal({key: REQUIRED}).endswith("; got nothing")


def test_a_parameter_without_default_must_be_given() -> None:
    assert refusal({}, Needy, "map.") == "map.path: expected a text; got nothing"
    assert refusal({"path": "???"}, Needy, "map.") == "map.path: expected a text; got nothing"
    assert build(Needy, {"path": "yard.txt"}).path == "yard.txt"


def test_an_unknown_key_is_refused_with_those_that_are_known() -> None:
    assert refusal({"file": "x"}, Needy, "map.") == "map.file is not a known key; expected one of: map.path"


def test_a_part_without_parameters_says_so() -> None:
    assert refusal({"gamma": 1}, Bare, "post.").startswith("post.gamma is not a known key; ")
    assert "it has no parameters" in refusal({"gamma": 1}, Bare)


@pytest.mark.parametrize("key", ["share", "ants"])
@pytest.mark.parametrize("value", [np.array([1, 2]), np.array([1]), np.zeros((2, 2)), Fraction(10**400), HUGE])
def test_whatever_comes_the_refusal_is_a_settings_error(key: str, value: Any) -> None:
    assert refusal({key: value}).startswith(f"{key}: expected ")
