"""Configurations: from texts such as a person writes, or refused with the key that they stand under."""

from __future__ import annotations

from typing import Any

import pytest

from acoexp import SettingsError
from acoexp.compare.configuration import Configuration, parse_configurations
from acoexp.registry.resolve import resolve
from acoexp.trial.settings import Settings


def parsed(text: str, base: dict[str, Any] | None = None) -> Configuration:
    """Return one configuration, beside another."""
    return parse_configurations([text, "aco rho=0.123"], base or {})[0]


def settings(text: str, base: dict[str, Any] | None = None) -> Settings:
    """Return one configuration's settings."""
    return parsed(text, base).settings


def test_a_presets_name_is_that_preset() -> None:
    assert settings("pd") == resolve("pd", {})


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("pdg diffusion.gamma=0.02", {"diffusion": {"gamma": 0.02}}),
        ("pdg diffusion=none", {"diffusion": "none"}),
        ("pdg diffusion=gaussian diffusion.gamma=1e-3", {"diffusion": {"name": "gaussian", "gamma": 0.001}}),
        ("pdg rho=0.3 ants=5", {"rho": 0.3, "ants": 5}),
        ("pdg field.reach=3", {"field": {"reach": 3.0}}),
    ],
)
def test_overrides_are_those_of_the_command_line(text: str, same: dict[str, Any]) -> None:
    assert settings(text) == resolve("pdg", same)


def test_the_command_lines_scalars_hold_unless_a_configuration_says_otherwise() -> None:
    base = {"ants": 7, "rho": 0.4, "field": {"reach": 3.0, "repulsion": 2.0}}
    found = settings("pd ants=9 field.reach=5", base)
    assert found == resolve("pd", {"ants": 9, "rho": 0.4, "field": {"reach": 5.0, "repulsion": 2.0}})


def test_a_label_has_single_blanks() -> None:
    assert parsed("  pd   ants=9 ").label == "pd ants=9"


@pytest.mark.parametrize("text", ["my own: pd ants=9", "my own:pd  ants=9", " my  own :pd ants=9"])
def test_a_configuration_may_have_a_name(text: str) -> None:
    assert parsed(text) == Configuration("my own", "pd ants=9", resolve("pd", {"ants": 9}))


def test_a_colon_in_a_value_is_no_name() -> None:
    with pytest.raises(SettingsError, match="rho: expected a number"):
        parsed("pd rho=a:b")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("nope", "algo: expected one of: "),
        ("", "algo: expected one of: "),
        ("pdg difusion=none", "difusion is not a known key; expected one of: "),
        ("pdg diffusion=nope", "diffusion: expected one of: "),
        ("pdg diffusion.gama=1", "diffusion.gama is not a known key; expected one of: diffusion.gamma"),
        ("pdg rho=1.5", "rho: expected a number from 0 to 1; got 1.5"),
        ("pdg rho", "expected key=value; got 'rho'"),
        ("pdg =1", "expected key=value; got '=1'"),
        ("pdg rho=[", "expected key=value, as on the command line"),
        ("pdg rho.x=1", "rho: expected a number from 0 to 1; got {'x': 1}"),
        ("pdg field=3", "field: expected a mapping of parameters; got 3"),
        ("pdg rho=${ants}", "rho: expected a number from 0 to 1; got '${ants}'"),
        ("pdg seed=3", "seed is not a known key"),
        ("pdg [=1", "expected key=value; got '[=1'"),
        ("pdg rho[0]=1", "expected key=value; got 'rho[0]=1'"),
        ("pdg .=1", "expected key=value; got '.=1'"),
        ("pdg rho=!!python/object:os.system", "expected key=value, as on the command line; got 'rho=!!python"),
        ("pdg rho=*a", "expected key=value, as on the command line; got 'rho=*a'"),
    ],
)
def test_a_bad_configuration_is_refused_in_one_line(text: str, said: str) -> None:
    with pytest.raises(SettingsError) as caught:
        parsed(text)
    assert str(caught.value).startswith(f"report.cells: {text!r}: {said}")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("value", ["1" * 5000, "[" * 3000, "x" * 100_000])
def test_of_what_is_very_long_the_beginning_is_shown(value: str) -> None:
    with pytest.raises(SettingsError, match=r"^report.cells: 'pdg ants=") as caught:
        parsed(f"pdg ants={value}")
    assert len(str(caught.value)) < 800


def test_what_a_terminal_would_obey_is_no_part_of_a_name() -> None:
    assert parsed("\x1b[31mred: pd").label == r"\x1b[31mred"


@pytest.mark.parametrize("texts", [[], ["aco"], ["aco", "pd", " aco "]])
def test_fewer_than_two_or_one_twice_is_refused(texts: list[str]) -> None:
    with pytest.raises(SettingsError, match=r"report\.cells: expected two or more, each different"):
        parse_configurations(texts, {})
