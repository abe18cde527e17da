"""Errors: what a user meets can be caught as one thing, and a word that was misspelt is recognised."""

from __future__ import annotations

import pytest

from acoexp import errors
from acoexp.errors import (
    AcoexpError,
    MapError,
    SettingsError,
    StoreGoneError,
    StrategyError,
    did_you_mean,
    shown,
)


def test_whatever_is_raised_on_purpose_is_caught_as_one_kind() -> None:
    kinds = [kind for kind in vars(errors).values() if isinstance(kind, type) and issubclass(kind, Exception)]
    assert {MapError, SettingsError, StoreGoneError, StrategyError} <= set(kinds)
    assert all(issubclass(kind, AcoexpError) for kind in kinds)


@pytest.mark.parametrize(
    ("kind", "usual"), [(SettingsError, ValueError), (MapError, ValueError), (StoreGoneError, OSError)]
)
def test_who_knows_python_alone_catches_what_a_function_of_python_would_raise(
    kind: type[Exception], usual: type[Exception]
) -> None:
    with pytest.raises(usual, match="what is wrong"):
        raise kind("what is wrong")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("gausian", "; did you mean gaussian?"),
        ("Gaussian", "; did you mean gaussian?"),
        ("luowu", "; did you mean luo_wu?"),
        ("gauss", ""),
        ("", ""),
        (None, ""),
        (5, ""),
    ],
)
def test_a_word_much_like_a_known_one_is_recognised(given: object, said: str) -> None:
    assert did_you_mean(given, ["none", "gaussian", "luo_wu"]) == said


def test_the_known_words_may_be_any_iterable() -> None:
    assert did_you_mean("rhoo", {"rho": 0.5, "ants": 10}) == "; did you mean rho?"
    assert did_you_mean("rhoo", (key for key in ("rho", "ants"))) == "; did you mean rho?"


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("a b", "'a b'"),
        (None, "None"),
        (10**200 - 1, "9" * 200),
        (10**200, "a number of more than 200 digits"),
        (-(10**9000), "a number of more than 200 digits"),
        ([10**9000], "a list"),
        ("x" * 198, "'" + "x" * 198 + "'"),
        ("x" * 1000, "'" + "x" * 199 + "... (1002 characters)"),
    ],
    ids=lambda value: str(type(value)),
)
def test_a_message_shows_what_came_and_of_what_is_long_its_beginning(value: object, said: str) -> None:
    assert shown(value) == said
