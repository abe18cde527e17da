"""The orders in which the ants of a cycle walk, by name."""

from __future__ import annotations

from acoexp.colony.two_ended import at_both_ends, two_ended
from acoexp.colony.walk import Order, in_turn, lock_step

ORDERS: dict[str, Order] = {
    "in_turn": Order(in_turn),
    "lock_step": Order(lock_step),
    "two_ended": Order(two_ended, at_both_ends),
}
