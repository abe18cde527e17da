"""Failures: an error names the part at fault, and no other, as long as anybody can know."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

import numba
import pytest

from acoexp.colony.compiled import compiled
from acoexp.registry.resolve import resolve
from acoexp.strategies import Choice, Diffusion
from acoexp.trial.failures import culprit, not_compiled, raised, suspects
from acoexp.trial.settings import Settings

compiling = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")


@compiled
def blow(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    raise ValueError("too windy")


@compiled
def hesitate(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    return 8


class Breeze(Diffusion):
    kernel = staticmethod(blow)


class Hesitant(Choice):
    kernel = staticmethod(hesitate)


BUILT_IN = resolve("aco", {})
BREEZY = resolve("aco", {"diffusion": Breeze()})
BOTH = resolve("aco", {"diffusion": Breeze(), "choice": Hesitant()})
PACKAGE = BUILT_IN.chosen["choice"].package


def of_python(kernel: Any) -> Callable[..., Any]:
    """Return the function that was compiled."""
    function: Callable[..., Any] = getattr(kernel, "py_func", kernel)
    return function


def line_of(text: str) -> str:
    """Return where in this file a line stands, as a message tells it."""
    lines = inspect.getsource(inspect.getmodule(Breeze) or Breeze).splitlines()
    return f"{__file__}:{lines.index(text) + 1}: {text.strip()}"


@compiling
@pytest.mark.parametrize(
    ("settings", "who"),
    [
        (BREEZY, "diffusion 'Breeze'"),
        (BOTH, "choice 'Hesitant' or diffusion 'Breeze'"),
        (
            BUILT_IN,
            "the colony (heuristic=goal_distance, choice=roulette, diffusion=none, post=none, update=ant_cycle)",
        ),
    ],
)
def test_what_cannot_be_compiled_is_most_likely_not_built_in(settings: Settings, who: str) -> None:
    said = str(not_compiled(settings, TypeError("odd")))
    assert said == f"{who} cannot be compiled: odd"


@compiling
def test_of_two_parts_the_one_whose_kernel_the_compiler_names_is_at_fault() -> None:
    problem = TypeError(f"odd: {of_python(Hesitant.kernel)!r}")
    assert str(not_compiled(BOTH, problem)).startswith("choice 'Hesitant' cannot be compiled: odd")


@compiling
def test_of_two_parts_the_one_in_whose_file_the_compiler_stopped_is_told_with_its_line() -> None:
    number = int(line_of("    return 8").split(":")[1])
    problem = TypeError(f"Unknown attribute 'nothing' of type Colony\n at {__file__} ({number})")
    said = str(not_compiled(BREEZY, problem))
    assert said == f"diffusion 'Breeze' cannot be compiled: colony has no 'nothing'; {line_of('    return 8')}"


def what_raised(settings: Settings, function: Callable[..., Any], *args: Any) -> str:
    """Return what is said of what a function raises."""
    with pytest.raises(Exception) as caught:  # noqa: PT011, whatever it is
        function(*args)
    return str(raised(settings, 3, caught.value))


def test_a_kernel_that_raised_is_named_with_its_authors_line() -> None:
    said = what_raised(BREEZY, of_python(Breeze.kernel), *[None] * 5)
    place = line_of('    raise ValueError("too windy")')
    assert said == f"the kernel of diffusion 'Breeze' raised, seed 3: ValueError: too windy; {place}"


def test_an_error_of_which_nobody_knows_where_it_came_from_is_suspected_of_the_foreign_part() -> None:
    said = str(raised(BREEZY, 3, ValueError("odd")))
    assert said.startswith("a kernel of the colony (heuristic=goal_distance, choice=roulette, diffusion=Breeze, ")
    assert said.endswith(" raised, seed 3: ValueError: odd; most likely diffusion 'Breeze'")


def test_among_built_in_parts_nobody_is_suspected_of_an_error() -> None:
    assert str(raised(BUILT_IN, 3, ValueError("odd"))).endswith(" raised, seed 3: ValueError: odd")


def test_suspects_are_the_foreign_parts_or_else_all_that_act() -> None:
    assert suspects(BOTH) == "most likely choice 'Hesitant' or diffusion 'Breeze'"
    assert suspects(BUILT_IN) == " or ".join(map(BUILT_IN.describe, ("choice", "diffusion", "update")))


def test_a_built_in_part_in_which_it_came_to_light_is_not_blamed_for_a_foreign_one() -> None:
    assert culprit(BREEZY, "diffusion") == "diffusion 'Breeze'"
    assert culprit(BUILT_IN, "choice") == BUILT_IN.describe("choice")
    assert culprit(BREEZY, "choice") == (
        f"most likely diffusion 'Breeze' (choice 'roulette' of package {PACKAGE} is built in)"
    )
