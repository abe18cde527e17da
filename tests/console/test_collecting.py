"""The collector of cyclic garbage: off while a command gets ready, then on for what is made from then on."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Iterator

import pytest

from acoexp.console.collecting import begin_without, collect_from_now_on


class Knot:
    """An object that refers to itself."""

    def __init__(self) -> None:
        self.itself = self


@pytest.fixture(autouse=True)
def as_before() -> Iterator[None]:
    """Leave the collector as it was found."""
    yield
    gc.unfreeze()
    gc.enable()


def test_what_is_there_when_it_begins_is_never_looked_through_again() -> None:
    begin_without()
    assert not gc.isenabled()
    before = weakref.ref(Knot())
    collect_from_now_on()
    after = weakref.ref(Knot())
    gc.collect()
    assert gc.isenabled()
    assert (before() is None, after() is None) == (False, True)


def test_where_it_was_never_off_nothing_changes() -> None:
    knot = weakref.ref(Knot())
    collect_from_now_on()
    gc.collect()
    assert (gc.isenabled(), knot(), gc.get_freeze_count()) == (True, None, 0)
