"""Parameters as a person reads them: meaning, default and choices, from the declaration alone."""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from acoexp.console.parameters import described_parameters, in_columns, shown_default, summary_of
from acoexp.parameters import REQUIRED, parameter


@dataclass(frozen=True, kw_only=True)
class Breeze:
    """It blows.

    Where it comes from nobody knows.
    """

    strength: float = parameter(0.5, "how strong", minimum=0.0)
    where: str = parameter("north", "whence it blows", choices=("west", "north", "south"))
    file: str = parameter(REQUIRED, "what it is read from")


class Nameless:
    pass


def test_a_class_is_summed_up_by_the_first_line_of_its_docstring() -> None:
    assert summary_of(Breeze) == "It blows."
    assert summary_of(Nameless) == ""


def test_each_key_has_its_meaning_and_default_and_what_else_it_may_be() -> None:
    assert described_parameters(Breeze, "diffusion.") == {
        "diffusion.strength": "how strong [0.5]",
        "diffusion.where": "whence it blows [north, or west, south]",
        "diffusion.file": "what it is read from [???]",
    }


def test_a_class_without_parameters_has_no_lines() -> None:
    assert described_parameters(Nameless) == {}


@pytest.mark.parametrize(
    ("value", "shown"),
    [(True, "true"), (False, "false"), (None, "null"), (("aco", "pd"), "aco, pd"), ((), ""), (1e-100, "1e-100")],
)
def test_a_default_is_shown_as_the_command_line_would_take_it(value: object, shown: str) -> None:
    assert shown_default(value) == shown


def test_meanings_stand_in_one_column() -> None:
    assert in_columns({"a": "first", "longer": "second"}) == "  a       first\n  longer  second\n"
    assert in_columns({}) == ""
