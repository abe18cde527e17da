"""Preparation: each part is asked once before any ant walks, and its answer is checked."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from samples import drawn, problem_on

from acoexp.colony.problem import Problem
from acoexp.colony.state import Prepared
from acoexp.errors import SettingsError, StrategyError
from acoexp.registry.resolve import resolve
from acoexp.trial import preparation
from acoexp.trial.preparation import DESIRABILITY_LIMIT, prepare
from acoexp.trial.settings import Chosen

E, NE, N, NW, W, SW, S, SE = range(8)

GRID, _ = drawn("a#. ..b")
SCALARS: dict[str, Any] = {"beta": 2.0, "tau0": 0.5}


class Answering:
    """A part that answers what it is told to."""

    def __init__(self, **answers: Any) -> None:
        self.answers = answers

    def _answer(self, name: str, default: Any) -> Any:
        answer = self.answers.get(name, default)
        if isinstance(answer, BaseException):
            raise answer
        return answer

    def prepare(self, problem: Problem) -> Any:
        return self._answer("prepare", ())

    def eta(self, problem: Problem) -> Any:
        return self._answer("eta", 1.0)

    def initial(self, problem: Problem) -> Any:
        return self._answer("initial", problem.settings.tau0)


class Stubborn:
    """What will not become an array."""

    def __init__(self, problem: BaseException) -> None:
        self.problem = problem

    def __array__(self, *_: Any, **__: Any) -> Any:
        raise self.problem


def prepared(scalars: dict[str, Any] = SCALARS, **parts: Answering) -> Prepared:
    """Return what is prepared where some parts answer what they are told to."""
    settings = resolve("aco", scalars)
    mine = {group: Chosen("mine", None, part) for group, part in parts.items()}
    return prepare(problem_on(GRID, **scalars), replace(settings, chosen={**settings.chosen, **mine}))


def refusal(**parts: Answering) -> str:
    """Return the message with which an answer is refused."""
    with pytest.raises(StrategyError) as caught:
        prepared(**parts)
    return str(caught.value)


def per_move(values: Any) -> Any:
    """Return values per edge of the bordered map, by row, column and direction of the map without it."""
    return np.asarray(values).reshape(GRID.shape[0] + 2, GRID.shape[1] + 2, 8)[1:-1, 1:-1]


def test_each_parts_state_stands_under_its_group() -> None:
    states = {group: (float(place), np.arange(place)) for place, group in enumerate(("choice", "post", "update"))}
    own = prepared(**{group: Answering(prepare=state) for group, state in states.items()}).own
    assert {group: getattr(own, group) for group in states} == states


def test_desirability_is_eta_to_the_beta_where_a_move_is_allowed_and_0_elsewhere() -> None:
    eta = np.arange(48.0).reshape(2, 3, 8)
    desirability = prepared(heuristic=Answering(eta=eta)).desirability
    allowed = problem_on(GRID).allowed_edges()
    assert np.array_equal(per_move(desirability), np.where(allowed, eta**2.0, 0.0))
    assert np.count_nonzero(desirability) == np.count_nonzero(allowed)  # and 0 on the border


def test_what_eta_says_of_moves_that_are_not_allowed_does_not_matter() -> None:
    allowed = problem_on(GRID).allowed_edges()
    eta = np.where(allowed, 3.0, np.where(np.arange(8) % 2, np.nan, -1.0))
    assert np.array_equal(per_move(prepared(heuristic=Answering(eta=eta)).desirability), np.where(allowed, 9.0, 0))


@pytest.mark.parametrize("strip", [1, 7])
def test_it_does_not_matter_how_many_rows_are_looked_at_at_a_time(
    strip: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    eta = np.arange(48.0).reshape(2, 3, 8)
    whole = prepared(heuristic=Answering(eta=eta)).desirability
    monkeypatch.setattr(preparation, "_STRIP", strip)
    assert np.array_equal(prepared(heuristic=Answering(eta=eta)).desirability, whole)


def test_desirability_is_cut_off_where_sums_of_weights_might_overflow() -> None:
    assert prepared(heuristic=Answering(eta=1e200)).desirability.max() == DESIRABILITY_LIMIT


def test_one_level_of_pheromone_is_one_number() -> None:
    assert prepared().initial.tolist() == [0.5]


def test_pheromone_may_begin_with_a_level_for_each_move() -> None:
    levels = np.arange(48.0).reshape(2, 3, 8)
    assert np.array_equal(per_move(prepared(update=Answering(initial=levels)).initial), levels)


def test_where_pheromone_lies_on_cells_all_moves_into_one_share_the_mean() -> None:
    levels = np.arange(48.0).reshape(2, 3, 8)
    initial = per_move(prepared({**SCALARS, "pheromone": "cells"}, update=Answering(initial=levels)).initial)
    into = [((1, 0), E), ((1, 2), W), ((0, 0), SE), ((0, 2), SW)]  # the cell in the middle of the lower row
    assert {float(initial[cell][d]) for cell, d in into} == {np.mean([levels[cell][d] for cell, d in into])}


@pytest.mark.parametrize(
    ("state", "came"),
    [
        ([1.0], "list"),
        (None, "NoneType"),
        ((1.0, "two"), "str at place 1"),
        ((np.array(["a"]),), "ndarray at place 0"),
        ((np.zeros(1), [2.0]), "list at place 1"),
    ],
)
def test_a_state_that_no_kernel_can_take_is_refused(state: Any, came: str) -> None:
    said = "diffusion 'mine': expected prepare to return a tuple of numbers and arrays; got "
    assert refusal(diffusion=Answering(prepare=state)) == said + came


@pytest.mark.parametrize(
    ("eta", "came"),
    [
        (np.ones((3, 2, 8)), "float64 of shape (3, 2, 8)"),
        (np.ones(7), "float64 of shape (7,)"),
        (np.ones((2, 3, 8)) * 1j, "complex128 of shape (2, 3, 8)"),
        (np.full((2, 3, 8), None), "object of shape (2, 3, 8)"),
        (1j, "complex"),
        ("much", "str"),
        ("1.0", "str"),
        (Stubborn(ValueError("no")), "Stubborn"),
        (Stubborn(SystemExit(3)), "Stubborn"),
        ([[1.0], [1.0, 2.0]], "list"),
    ],
)
def test_eta_of_another_shape_is_refused(eta: Any, came: str) -> None:
    said = "heuristic 'mine': expected eta to return numbers of a shape that broadcasts to (2, 3, 8); got "
    assert refusal(heuristic=Answering(eta=eta)).startswith(said + came)


@pytest.mark.parametrize(("group", "method"), [("heuristic", "eta"), ("update", "initial")])
def test_a_return_that_was_forgotten_is_told(group: str, method: str) -> None:
    assert refusal(**{group: Answering(**{method: None})}) == (
        f"{group} 'mine': expected {method} to return numbers; got None, which is what a function without a "
        "return gives"
    )


@pytest.mark.parametrize("odd", [-1.0, np.nan, np.inf])
@pytest.mark.parametrize(("group", "method"), [("heuristic", "eta"), ("update", "initial")])
def test_numbers_that_are_negative_or_not_finite_are_refused(group: str, method: str, odd: float) -> None:
    values = np.ones((2, 3, 8))
    values[1, 0, E] = odd
    assert refusal(**{group: Answering(**{method: values})}) == (
        f"{group} 'mine': expected {method} to return numbers that are finite, and at least 0, on every move; "
        "got others"
    )


@pytest.mark.parametrize(("group", "method"), [("choice", "prepare"), ("heuristic", "eta"), ("update", "initial")])
def test_a_part_that_fails_is_named_with_its_authors_line(group: str, method: str) -> None:
    said = refusal(**{group: Answering(**{method: ValueError("too bad")})})
    assert said.startswith(f"{group} 'mine' failed in {method}: ValueError: too bad; {__file__}:")
    assert said.endswith(": raise answer")


@pytest.mark.parametrize(("group", "method"), [("choice", "prepare"), ("heuristic", "eta"), ("update", "initial")])
def test_a_part_that_wants_to_end_the_program_fails_like_others(group: str, method: str) -> None:
    said = refusal(**{group: Answering(**{method: SystemExit(3)})})
    assert said.startswith(f"{group} 'mine' failed in {method}: SystemExit: 3; {__file__}:")


def test_what_a_part_refuses_on_purpose_is_said_in_its_own_words() -> None:
    with pytest.raises(SettingsError, match=r"^ants: expected an even number$"):
        prepared(choice=Answering(prepare=SettingsError("ants: expected an even number")))
