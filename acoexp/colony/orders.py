"""The orders in which the ants of a cycle walk, by name, and what each needs beside its walk."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from acoexp.colony.state import Kernel
from acoexp.colony.steps import idle
from acoexp.colony.two_ended import at_both_ends, two_ended
from acoexp.colony.walk import Walk, in_turn, lock_step


def _at_one_end(update: Kernel) -> tuple[Kernel, Kernel]:
    return idle, idle


class Order(NamedTuple):
    """An order.

    Attributes:
        walk: Makes the walk's kernels, see :mod:`acoexp.colony.walk`.
        facing: Makes two kernels of the one that updates: ``begin(room)``, called when a trial begins, and
            ``close(room)``, called after each update; they see to a second colony, if there is one.
    """

    walk: Walk
    facing: Callable[[Kernel], tuple[Kernel, Kernel]] = _at_one_end


ORDERS: dict[str, Order] = {
    "in_turn": Order(in_turn),
    "lock_step": Order(lock_step),
    "two_ended": Order(two_ended, at_both_ends),
}
