"""The collector of cyclic garbage: off while a command gets ready, then on for what is made from then on."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Iterator

import pytest

from acoexp.console.collecting import begin_without, collect_from_now_on, set_aside


class Knot:
    """An object that refers to itself."""

    def __init__(self) -> None:
        self.itself = self


@pytest.fixture(autouse=True)
def as_before() -> Iterator[None]:
    """Leave the collector as it was found."""
    often = gc.get_threshold()
    yield
    gc.set_threshold(*often)
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


def test_what_is_set_aside_is_no_garbage_by_then() -> None:
    before = weakref.ref(Knot())
    kept = Knot()
    set_aside()
    stays = weakref.ref(kept)
    del kept
    gc.collect()
    assert (before() is None, stays() is None) == (True, False)


def test_where_it_was_never_off_nothing_changes() -> None:
    often, frozen = gc.get_threshold(), gc.get_freeze_count()
    collect_from_now_on()
    assert (gc.isenabled(), gc.get_threshold(), gc.get_freeze_count()) == (True, often, frozen)
