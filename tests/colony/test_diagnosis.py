"""Diagnosis: the compiler's errors in the words of a kernel's author, with the author's own line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numba
import numpy as np
import pytest
from samples import colony_on, problem_on

from acoexp.colony.compiled import compiled
from acoexp.colony.diagnosis import compiled_functions, explain, place_of, raised_at, sources_of
from acoexp.colony.pheromone import deposit
from acoexp.grid import Grid
from acoexp.strategies import Diffusion

pytestmark = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")


def not_compiled(colony: Any) -> None:
    """Do nothing."""


@compiled
def make_an_array(colony: Any, own: Any, cell: Any) -> Any:
    return np.zeros(3)[0]  # here: allocate


@compiled
def make_a_list(colony: Any, own: Any, cell: Any) -> Any:
    return [cell, cell + 1][0]  # here: list


@compiled
def make_a_text(colony: Any, own: Any, cell: Any) -> None:
    print(f"cell {cell}")  # here: text


@compiled
def write_where_it_may_not(colony: Any, own: Any, cell: Any) -> None:
    colony.allowed[cell] = 0  # here: read-only


@compiled
def use_what_is_not_there(colony: Any, own: Any, cell: Any) -> None:
    deposit(colony, cell, amount)  # type: ignore[name-defined]  # noqa: F821  # here: undefined


@compiled
def look_at_what_is_not_there(colony: Any, own: Any, cell: Any) -> Any:
    return colony.untuched[cell]  # here: attribute


@compiled
def call_another(colony: Any, own: Any, cell: Any) -> Any:
    return look_at_what_is_not_there(colony, own, cell)


@compiled
def leave_out_the_amount(colony: Any, own: Any, cell: Any) -> None:
    deposit(colony, cell)  # type: ignore[call-arg]  # here: call


@compiled
def lay_an_array(colony: Any, own: Any, cell: Any) -> None:
    deposit(colony, cell, colony.untouched)  # here: array


@compiled
def call_what_is_not_compiled(colony: Any, own: Any, cell: Any) -> None:
    not_compiled(colony)  # here: plain


@compiled
def name_a_tuples_entry(colony: Any, own: Any, cell: Any) -> Any:
    return own.share  # here: tuple


@compiled
def change_a_setting(colony: Any, own: Any, cell: Any) -> None:
    colony.rho = 0.5  # here: setting


@compiled
def ask_numpy_for_what_it_has_not(colony: Any, own: Any, cell: Any) -> Any:
    return np.zeroes(3)  # here: numpy


NO_MEMORY = "a kernel must not allocate memory (new arrays, lists, texts), prepare may"
SAID = {
    make_an_array: (NO_MEMORY, "allocate"),
    make_a_list: (NO_MEMORY, "list"),
    make_a_text: (NO_MEMORY, "text"),
    write_where_it_may_not: ("it writes to an array that is read-only; ", "read-only"),
    use_what_is_not_there: ("NameError: name 'amount' is not defined", "undefined"),
    look_at_what_is_not_there: ("colony has no 'untuched'; did you mean untouched?", "attribute"),
    call_another: ("colony has no 'untuched'; did you mean untouched?", "attribute"),
    leave_out_the_amount: (
        "deposit is not called with what it takes: missing a required argument: 'amount'",
        "call",
    ),
    lay_an_array: ("an array stands where a number is expected", "array"),
    call_what_is_not_compiled: ("it calls not_compiled, which is not @compiled", "plain"),
    name_a_tuples_entry: ("a tuple has no 'share'; ", "tuple"),
    change_a_setting: ("colony.rho cannot be replaced, only read", "setting"),
    ask_numpy_for_what_it_has_not: ("module 'numpy' has no attribute 'zeroes'", "numpy"),
}


@pytest.mark.parametrize("kernel", SAID, ids=lambda kernel: kernel.__name__)
def test_what_the_compiler_refuses_is_told_with_the_authors_own_line(kernel: Any) -> None:
    said, mark = SAID[kernel]
    colony = colony_on(problem_on(Grid(np.zeros((2, 2)))))
    typeof: Any = numba.typeof
    with pytest.raises(Exception) as caught:  # noqa: PT011  # numba's own are of many kinds
        kernel.compile((typeof(colony), typeof((1.0, 2.0)), numba.int64))
    assert explain(caught.value).startswith(said)
    place = place_of(caught.value, [Path(__file__)], [kernel.py_func])
    assert place is not None
    assert place.file == __file__
    assert str(place).endswith(f"# here: {mark}")


def test_an_error_of_nobodys_file_has_no_place() -> None:
    assert place_of(ValueError("no way at /somewhere/else.py (3)"), [Path(__file__)], []) is None


def test_what_is_raised_is_placed_at_the_authors_innermost_line() -> None:
    def fail() -> None:
        int("x")  # here: raised

    with pytest.raises(ValueError, match="invalid") as caught:
        fail()
    assert str(raised_at(caught.value, [Path(__file__)])).endswith("# here: raised")
    assert raised_at(caught.value, [Path("/somewhere")]) is None


def test_kept_machine_code_may_name_a_package_by_where_it_lay_before(tmp_path: Path) -> None:
    (tmp_path / "now" / "wild" / "inner").mkdir(parents=True)
    (tmp_path / "now" / "wild" / "inner" / "part.py").write_text("x = 1\n1 / 0\n", encoding="utf-8")
    for before, found in (("before/wild/inner/part.py", True), ("before/wild/other.py", False)):
        with pytest.raises(ZeroDivisionError) as caught:
            exec(compile("x = 1\n1 / 0\n", str(tmp_path / before), "exec"))
        place = str(raised_at(caught.value, [tmp_path / "now" / "wild"]))
        assert place == (f"{tmp_path}/now/wild/inner/part.py:2: 1 / 0" if found else "None")


def test_an_authors_sources_and_functions_are_those_of_the_top_level_package() -> None:
    class Own(Diffusion):
        kernel = staticmethod(make_a_list)

    assert Path(__file__) in sources_of(Own())
    from acoexp.strategies.diffusion.none import NoDiffusion

    assert Path(sources_of(NoDiffusion())[0]).name == "acoexp"
    assert deposit.py_func in compiled_functions(NoDiffusion)  # type: ignore[attr-defined]
