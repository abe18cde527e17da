"""``--info strategies``: every part in a line with its package, and what is broken once more at the end."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import pytest

from acoexp.command.options import listing
from acoexp.command.options.listing import parts_text
from acoexp.errors import StrategyError
from acoexp.parameters import fields_of
from acoexp.registry.entries import GROUPS, part_names
from acoexp.registry.parts import find_part
from acoexp.registry.presets import find_preset, preset_names
from acoexp.strategies.part import CONTRACT

ACOEXP = f"acoexp {version('acoexp')}"


@pytest.fixture(scope="module")
def text() -> str:
    """Return the list."""
    return parts_text()


def section(text: str, title: str) -> list[str]:
    """Return the lines of one section."""
    return text.partition(f"== {title} ==\n")[2].partition("\n== ")[0].splitlines()


def test_it_begins_with_the_version_and_the_contract(text: str) -> None:
    assert text.splitlines()[0] == f"{ACOEXP}, contract {CONTRACT}"


@pytest.mark.parametrize("group", GROUPS)
def test_each_part_has_a_line_and_each_of_its_parameters_one(text: str, group: str) -> None:
    lines = section(text, group)
    heads = [line for line in lines if line and not line.startswith(" ")]
    assert [head.split()[0] for head in heads] == part_names(group)
    keys = [line.split()[0] for line in lines if line.startswith("    ")]
    assert keys == [f"{group}.{key}" for name in part_names(group) for key in fields_of(find_part(group, name))]


def test_a_part_says_whose_it_is_for_which_contract_and_where_it_lies(text: str) -> None:
    said = f"gaussian  package {ACOEXP}, contract 1, acoexp.strategies.diffusion.gaussian:Gaussian"
    assert said in section(text, "diffusion")
    assert f"fig13  package {ACOEXP}, acoexp.maps.builtin:Fig13" in section(text, "map")


def test_a_preset_says_which_parts_it_consists_of(text: str) -> None:
    lines = {line.split()[0]: line for line in section(text, "algo") if line}
    assert list(lines) == preset_names()
    parts = " ".join(f"{group}={part}" for group, part in find_preset("pdg").parts.items())
    assert lines["pdg"] == f"pdg  package {ACOEXP}: {parts}"


def test_what_is_broken_is_told_in_its_place_and_at_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    def find(group: str, name: str, real: Any = find_part) -> Any:
        if name == "luo_wu":
            raise StrategyError("luo_wu cannot\n be imported \x1b[31m")
        return real(group, name)

    monkeypatch.setattr(listing, "find_part", find)
    monkeypatch.setattr(listing, "missing_folders", lambda: ["presets of package x: expected a folder"])
    text = parts_text()
    assert "luo_wu  BROKEN: luo_wu cannot be imported \\x1b[31m" in section(text, "diffusion")
    assert section(text, "broken") == [
        "BROKEN: luo_wu cannot be imported \\x1b[31m",
        "BROKEN: presets of package x: expected a folder",
    ]


def test_two_parts_of_one_name_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def clash(group: str, name: str) -> str | None:
        return "two packages call a diffusion 'none'" if (group, name) == ("diffusion", "none") else None

    monkeypatch.setattr(listing, "clash", clash)
    lines = section(parts_text(), "diffusion")
    place = next(place for place, line in enumerate(lines) if line.startswith("none "))
    assert lines[place + 1] == "    BROKEN: two packages call a diffusion 'none'"
