"""YAML of a bounded size: aliases count as what they stand for; see also the option files that rely on it."""

from __future__ import annotations

import pytest
import yaml

from acoexp.console.bounded import check_bounded

BOMB = "a0: &a0 [x, x]\n" + "".join(f"a{n}: &a{n} [*a{n - 1}, *a{n - 1}]\n" for n in range(1, 60))


@pytest.mark.parametrize("text", ["", "x", "[1, 2]", "a: {b: [1]}", "a: &a [1]\nb: *a\n"])
def test_what_is_small_passes(text: str) -> None:
    check_bounded(text, 9)


@pytest.mark.parametrize("text", ["[1, 2, 3]", "a: &a [1]\nb: *a\n", BOMB, "x: &x [*x]\n", "x: &x {a: *x}\n"])
def test_what_is_larger_written_out_or_has_no_end_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="its aliases make it endless, or too large"):
        check_bounded(text, 3)


def test_what_is_no_yaml_or_too_deep_is_left_to_the_caller() -> None:
    with pytest.raises(yaml.YAMLError):
        check_bounded("[", 9)
    with pytest.raises(RecursionError):
        check_bounded("[" * 5000, 9)
    with pytest.raises(RecursionError):
        check_bounded("{[" * 51, 9)
