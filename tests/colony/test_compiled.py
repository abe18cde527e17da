"""How kernels are compiled."""

from __future__ import annotations

from typing import Any

import numba
import numpy as np
import pytest

from acoexp.colony.compiled import compiled, compiled_for_python, is_compiled

JIT_ALONE = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")


def quotient(numerator: float, denominator: float) -> float:
    return numerator / denominator


def allocated(size: int) -> Any:
    return np.zeros(size)


@JIT_ALONE
def test_nothing_is_compiled_before_the_first_call() -> None:
    kernel: Any = compiled(quotient)
    assert not kernel.from_python.signatures
    kernel(1.0, 2.0)
    assert len(kernel.from_python.signatures) == 1


@JIT_ALONE
def test_compiled_code_takes_it_without_what_a_call_from_python_needs() -> None:
    kernel: Any = compiled(quotient)

    @compiled_for_python
    def half(number: float) -> float:
        return kernel(number, 2.0)  # type: ignore[no-any-return]

    assert half(3.0) == 1.5
    assert len(kernel.signatures) == 1
    assert not kernel.from_python.signatures


@JIT_ALONE
def test_it_divides_by_zero_as_numpy_does() -> None:
    assert compiled(quotient)(1.0, 0.0) == np.inf


@JIT_ALONE
def test_it_cannot_allocate() -> None:
    refusals = r"NRT required but not enabled|Only accept returning of array"
    with pytest.raises(numba.core.errors.NumbaError, match=refusals):
        compiled(allocated)(3)


def test_it_is_told_from_other_functions() -> None:
    assert is_compiled(compiled(quotient))
    assert not is_compiled("no function")


@JIT_ALONE
@pytest.mark.parametrize("other", [quotient, numba.njit(quotient), numba.njit(nogil=True)(quotient)])
def test_what_is_compiled_in_another_way_is_told_from_it(other: Any) -> None:
    assert not is_compiled(other)
