"""The span of a key: which numbers are meant, how they are drawn, and what is refused."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
import pytest

from acoexp.sensitivity.span import Span, parse_span


@pytest.mark.parametrize(
    ("text", "whole", "expected"),
    [
        ("interval(0.1,0.9)", False, Span(0.1, 0.9)),
        (" interval( -1 , 1e-3 ) ", False, Span(-1.0, 0.001)),
        ("interval(5,50)", True, Span(5.0, 50.0, whole=True)),
        ("int(interval(10,50))", False, Span(10.0, 50.0, whole=True)),
        ("tag(log,interval(0.1,10))", False, Span(0.1, 10.0, log=True)),
        ("tag(log, int(interval(1, 100)))", True, Span(1.0, 100.0, log=True, whole=True)),
        ("range(10,50,10)", True, Span(10.0, 40.0, whole=True, values=(10.0, 20.0, 30.0, 40.0))),
        ("range(0,0.3,0.1)", False, Span(0.0, 0.2, values=(0.0, 0.1, 0.2))),
        ("range(1,4)", True, Span(1.0, 3.0, whole=True, values=(1.0, 2.0, 3.0))),
        ("choice(5,1,2)", False, Span(1.0, 5.0, values=(1.0, 2.0, 5.0))),
        ("0.5,0.25", False, Span(0.25, 0.5, values=(0.25, 0.5))),
    ],
)
def test_a_span_is_written_as_for_a_study(text: str, whole: bool, expected: Span) -> None:
    assert parse_span(text, whole) == expected


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "expected numbers, such as"),
        ("0.5", "expected numbers, such as"),
        ("interval(0.1)", "expected interval(low,high)"),
        ("interval(1,2,3)", "expected interval(low,high)"),
        ("interval(0.9,0.1)", "expected interval(low,high), from a number to a larger one"),
        ("interval(1,1)", "expected interval(low,high), from a number to a larger one"),
        ("interval(nan,1)", "expected numbers"),
        ("interval(0,inf)", "expected numbers"),
        ("interval(0,1e999)", "expected numbers"),
        (f"interval(0,{'9' * 5000})", "expected numbers"),
        ("interval(a,b)", "expected numbers"),
        ("interval(true,false)", "expected numbers"),
        ("interval(0.1,0.9", "expected numbers"),
        ("int(interval(1,9)", "expected numbers"),
        ("interval(1,9))", "expected numbers"),
        ("tag(log,interval(0,1))", "expected numbers above 0 with a log"),
        ("tag(log,range(1,5))", "expected interval(low,high)"),
        ("range(0,1e300,1e-9)", "expected range(start,stop,step) with from 2 to 1000 numbers"),
        ("range(0,5,0)", "expected range(start,stop,step)"),
        ("range(5,0,-1)", "expected range(start,stop,step)"),
        ("range(1)", "expected range(start,stop,step)"),
        ("choice(1)", "expected from 2 to 1000 different numbers"),
        ("choice(1,1)", "expected from 2 to 1000 different numbers"),
        ("choice(aco,pd)", "expected numbers"),
        (",".join(map(str, range(2000))), "expected from 2 to 1000 different numbers"),
    ],
)
def test_what_is_no_span_is_refused(text: str, said: str) -> None:
    with pytest.raises(ValueError, match="expected") as caught:
        parse_span(text, False)
    assert str(caught.value).startswith(said)


def test_a_key_of_whole_numbers_has_no_others() -> None:
    for text in ("interval(1,2.5)", "choice(1,1.5)", "interval(1,1e300)"):
        with pytest.raises(ValueError, match="expected whole numbers"):
            parse_span(text, True)


@pytest.mark.parametrize("span", [Span(1.0, 4.0, whole=True), Span(1.0, 4.0, values=(1.0, 2.0, 3.0, 4.0))])
def test_each_of_few_numbers_is_as_likely_as_any_other(span: Span) -> None:
    drawn = Counter(span.at(share) for share in (np.arange(4000) + 0.5) / 4000)
    assert drawn == {1.0: 1000, 2.0: 1000, 3.0: 1000, 4.0: 1000}


def test_numbers_are_spread_evenly_or_by_their_logarithm() -> None:
    assert [Span(2.0, 6.0).at(share) for share in (0.0, 0.25, 0.5)] == [2.0, 3.0, 4.0]
    assert Span(1.0, 100.0, log=True).at(0.5) == pytest.approx(10.0)
    assert Span(1.0, 100.0, log=True, whole=True).at(0.0) == 1.0


@pytest.mark.parametrize("log", [False, True])
@pytest.mark.parametrize("whole", [False, True])
def test_no_number_lies_outside(log: bool, whole: bool) -> None:
    span = Span(3.0, 7.0, log=log, whole=whole)
    drawn = [span.at(share) for share in (0.0, 0.1, math.nextafter(1.0, 0.0))]
    assert all(3.0 <= number <= 7.0 for number in drawn)
    assert (drawn[0], drawn[-1]) == (pytest.approx(3.0), pytest.approx(7.0))


def test_a_curve_goes_from_end_to_end() -> None:
    assert Span(0.0, 1.0).levels(5) == [0.0, 0.25, 0.5, 0.75, 1.0]
    assert Span(1.0, 100.0, log=True).levels(3) == [1.0, pytest.approx(10.0), 100.0]
    assert Span(1.0, 3.0, whole=True).levels(9) == [1.0, 2.0, 3.0]
    assert Span(1.0, 3.0, values=(1.0, 3.0)).levels(9) == [1.0, 3.0]
    many = tuple(float(value) for value in range(100))
    assert Span(0.0, 99.0, values=many).levels(3) == [0.0, 50.0, 99.0]


def test_it_is_said_as_a_person_reads_it() -> None:
    said = [str(Span(0.1, 0.9)), str(Span(1.0, 9.0, log=True)), str(Span(1.0, 5.0, values=(1.0, 2.0, 5.0)))]
    assert said == ["0.1 to 0.9", "1 to 9, by logarithm", "1, 2, 5"]
    many = tuple(float(value) for value in range(100))
    assert str(Span(0.0, 99.0, values=many)) == "0, 1, 2, ..., 99"


@pytest.mark.parametrize("text", ["int(interval(0.3,5))", "tag(log,int(interval(0.3,5)))", "int(interval(1,2.5))"])
def test_whole_numbers_have_whole_ends_whatever_the_key(text: str) -> None:
    with pytest.raises(ValueError, match="whole"):
        parse_span(text, whole=False)
