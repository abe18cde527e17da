"""How numbers are written in tables: with as many digits as matter, and their interval."""

from __future__ import annotations

from acoexp.report.table import interval, number, p_value


def test_numbers_have_three_digits() -> None:
    said = [number(value) for value in (0.0, 0.123, 1.0, 12.34, 123.4, 1234.5, float("inf"), float("nan"))]
    assert said == ["0.00", "0.12", "1.00", "12.3", "123", "1234", "∞", "-"]
    assert interval(0.5, 0.25, 1.0) == "0.50 [0.25, 1.00]"
    assert interval(float("inf"), float("nan"), float("inf")) == "∞"


def test_a_p_value_is_never_written_as_nothing() -> None:
    shown = [p_value(p) for p in (0.0, 0.00099, 0.001, 1.0)]
    assert shown == ["< 0.001", "< 0.001", "0.001", "1.000"]
