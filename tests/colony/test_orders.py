"""The orders in which ants walk: each name that a setting may have stands for one."""

from __future__ import annotations

from acoexp.colony.orders import ORDERS
from acoexp.colony.scalars import ColonySettings
from acoexp.parameters import fields_of


def test_each_order_that_may_be_asked_for_is_there() -> None:
    assert tuple(ORDERS) == fields_of(ColonySettings)["order"].metadata["choices"]
