"""Which keys are varied and over what; and the settings that they make."""

from __future__ import annotations

import math
from typing import Any

import pytest

from acoexp import SettingsError
from acoexp.registry.resolve import resolve
from acoexp.sensitivity.factors import parse_factors, settings_with
from acoexp.sensitivity.span import Factor, Span

PDG = resolve("pdg", {})


def parse(*texts: str, algo: str = "pdg", **values: Any) -> list[Factor]:
    return parse_factors(texts, algo, resolve(algo, values))


def test_a_key_has_the_span_that_is_said() -> None:
    rho, gamma = parse("rho=interval(0.1,0.9)", "diffusion.gamma = choice(0,0.01)")
    assert rho == Factor("rho", Span(0.1, 0.9), 0.5)
    assert gamma == Factor("diffusion.gamma", Span(0.0, 0.01, values=(0.0, 0.01)), 0.01)


def test_without_one_it_lies_about_the_command_lines_value_from_half_to_twice() -> None:
    alpha, ants = parse("alpha", "ants", alpha=2.0, ants=9)
    assert alpha == Factor("alpha", Span(1.0, 4.0, log=True), 2.0)
    assert ants == Factor("ants", Span(4.0, 18.0, log=True, whole=True), 9.0)


def test_no_further_than_the_key_may_go() -> None:
    assert parse("rho", rho=0.75)[0].span == Span(0.375, 1.0, log=True)
    assert parse("ants", ants=1)[0].span == Span(1.0, 2.0, log=True, whole=True)


def test_without_keys_they_are_the_colonys_and_the_numbers_of_its_parts() -> None:
    assert [f.key for f in parse()] == ["alpha", "beta", "rho", "heuristic.at_goal", "diffusion.gamma"]
    acs = {f.key for f in parse(algo="acs")}
    assert {"choice.q0", "choice.xi"} <= acs
    assert "diffusion.gamma" not in acs


def test_what_has_no_span_about_it_is_left_out_unless_it_is_named() -> None:
    assert "alpha" not in {factor.key for factor in parse(alpha=0.0)}
    with pytest.raises(
        SettingsError, match=r"^report.keys: 'alpha': expected a span, such as alpha=interval\(1,2\)"
    ):
        parse("alpha", alpha=0.0)
    assert math.isnan(parse("max_steps=interval(10,20)")[0].value)


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        (["nope"], "report.keys: 'nope': expected a key that is a number of this configuration, one of: alpha, "),
        (["order=choice(1,2)"], "report.keys: 'order': expected a key that is a number of this configuration"),
        (["seed=interval(0,9)"], "report.keys: 'seed': expected a key that is a number"),
        (["choice.q0"], "report.keys: 'choice.q0': expected a key that is a number of this configuration"),
        ([""], "report.keys: '': expected a key"),
        (["rho="], "report.keys: 'rho=': expected numbers, such as interval(0.1,0.9)"),
        (["rho=choice(a,b)"], "report.keys: 'rho=choice(a,b)': expected numbers"),
        (["rho=interval(0.5,1.5)"], "report.keys: rho: expected a number from 0 to 1; got 1.5"),
        (
            ["diffusion.gamma=interval(-1,1)"],
            "report.keys: diffusion.gamma: expected a number from 0 to 1; got -1",
        ),
        (["ants=interval(0,9)"], "report.keys: ants: expected a whole number from 1 to 100000; got 0"),
        (["ants=interval(1.5,9)"], "report.keys: 'ants=interval(1.5,9)': expected whole numbers"),
        (["rho", "rho"], "report.keys: expected at most 20 keys, each once; got ['rho', 'rho']"),
        (
            ["max_steps"],
            "report.keys: 'max_steps': expected a span, such as max_steps=interval(1,2), as none lies",
        ),
    ],
)
def test_what_cannot_be_varied_is_refused(texts: list[str], said: str) -> None:
    with pytest.raises(SettingsError) as caught:
        parse(*texts)
    assert str(caught.value).startswith(said)


def test_a_slip_of_the_pen_is_answered_with_what_was_meant() -> None:
    with pytest.raises(SettingsError, match=r"; did you mean diffusion\.gamma\?$"):
        parse("diffusion.gama")


def test_settings_differ_in_these_values_alone() -> None:
    made = settings_with(PDG, "pdg", {"rho": 0.25, "ants": 7.0, "diffusion.gamma": 0.5, "field.reach": 3.0})
    expected = resolve("pdg", {"rho": 0.25, "ants": 7, "diffusion": {"gamma": 0.5}, "field": {"reach": 3.0}})
    assert made.as_dict() == expected.as_dict()
    assert isinstance(made.scalars.ants, int)


def test_what_the_command_line_says_of_others_stays() -> None:
    given = resolve("pdg", {"post": "none", "beta": 3.0, "diffusion": {"gamma": 0.02}})
    made = settings_with(given, "pdg", {"rho": 0.25})
    assert made.as_dict() == {**given.as_dict(), "rho": 0.25}
