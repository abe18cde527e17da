"""How many threads: as many as are asked for, or one for each processor that this process may use."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest

import acoexp
from acoexp.errors import SettingsError
from acoexp.trial.threads import MOST_THREADS, check_threads


def test_where_none_is_given_there_is_one_for_each_processor() -> None:
    assert 1 <= check_threads(None) <= (os.cpu_count() or 1)


@pytest.mark.parametrize("threads", [1, np.int64(3), MOST_THREADS])
def test_a_number_is_taken_as_it_is(threads: int) -> None:
    assert (check_threads(threads), type(check_threads(threads))) == (threads, int)


@pytest.mark.parametrize("threads", [0, -1, MOST_THREADS + 1, pytest.param(10**5000, id="huge"), 1.0, True, "2"])
def test_what_is_no_number_of_threads_is_refused(threads: Any) -> None:
    with pytest.raises(SettingsError, match=r"^threads: expected a whole number from 1 to 4096; got "):
        check_threads(threads)


def test_from_python_it_is_refused_before_anything_runs() -> None:
    with pytest.raises(SettingsError, match=r"^threads: "):
        acoexp.solve_many("env2", "aco", [0], threads=10**6)
