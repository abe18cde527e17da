"""A package that is broken in one way or another: one error that names it, and everything else goes on."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numba
import pytest
from running import install

import acoexp
from acoexp import StrategyError, presets, registry
from acoexp.command.parts import parts_text
from acoexp.presets import find_preset, preset_names

PARTS = '''
from dataclasses import dataclass
from typing import ClassVar

from acoexp.colony.compiled import compiled
from acoexp.strategies import Choice, Diffusion


@compiled
def look_into_nothing(colony, own, ant, cell, came):
    colony.nothing[cell] = 1.0


@compiled
def stay(colony, own, ant, cell, came):
    pass


@compiled
def give_up(colony, own, ant, cell, came):
    raise ValueError("given up")


@compiled
def go_east(colony, own, ant, cell, came):
    return 0


@dataclass(frozen=True, kw_only=True)
class Uncompilable(Diffusion):
    """Does not compile."""

    kernel = staticmethod(look_into_nothing)


@dataclass(frozen=True, kw_only=True)
class Unprepared(Diffusion):
    """Raises in prepare."""

    kernel = staticmethod(stay)

    def prepare(self, problem):
        raise ZeroDivisionError("too bad")


@dataclass(frozen=True, kw_only=True)
class Listing(Diffusion):
    """Prepares what no kernel can take."""

    kernel = staticmethod(stay)

    def prepare(self, problem):
        return (1.0, [2.0])


@dataclass(frozen=True, kw_only=True)
class Raising(Diffusion):
    """Raises at a step."""

    kernel = staticmethod(give_up)


@dataclass(frozen=True, kw_only=True)
class Newer(Diffusion):
    """Asks for what is yet to come."""

    contract: ClassVar[int] = 2
    kernel = staticmethod(stay)


@dataclass(frozen=True, kw_only=True)
class Eastwards(Choice):
    """Goes through walls."""

    kernel = staticmethod(go_east)
'''
ENTRIES = """
[acoexp.diffusion]
uncompilable = bad_parts:Uncompilable
unprepared = bad_parts:Unprepared
listing = bad_parts:Listing
raising = bad_parts:Raising
newer = bad_parts:Newer
gaussian = bad_parts:Newer
absent = bad_parts:Absent

[acoexp.choice]
eastwards = bad_parts:Eastwards

[acoexp.presets]
bad = bad_parts
gone = no_such_package
odd = ..
"""
PRESETS = {
    "pdg": "algo: pdg\nrho: 0.9\n",
    "torn": "defaults: [\n",
    "empty": "",
    "misnamed": "defaults: []\nalgo: other\n",
    "partial": "defaults:\n  - override /post: none\nalgo: partial\n",
}
FEW = {"ants": 2, "iterations": 2}


@pytest.fixture(autouse=True)
def broken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Install a package of broken parts and presets for the length of a test."""
    presets = {f"bad_parts/conf/algo/{name}.yaml": text for name, text in PRESETS.items()}
    install(tmp_path, "bad-parts", ENTRIES, {"bad_parts/__init__.py": PARTS, **presets})
    monkeypatch.syspath_prepend(tmp_path)
    forget()
    yield
    monkeypatch.undo()
    forget()


def forget() -> None:
    for kept in (registry.entries, registry._claims, registry._settle, registry._load, presets.plugin_conf_dirs):
        kept.cache_clear()


compiling = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")


@pytest.mark.parametrize(
    ("group", "name", "said"),
    [
        pytest.param(
            "diffusion",
            "uncompilable",
            r"^diffusion 'uncompilable' of package bad-parts 1.0 cannot be compiled: colony has no 'nothing'; "
            r"\S+__init__.py:\d+: colony.nothing\[cell\] = 1.0$",
            marks=compiling,
        ),
        (
            "diffusion",
            "unprepared",
            "diffusion 'unprepared' of package bad-parts 1.0 failed in prepare: .*too bad",
        ),
        ("diffusion", "listing", "diffusion 'listing' of package bad-parts 1.0: expected .* got list at place 1"),
        (
            "diffusion",
            "raising",
            r"diffusion 'raising' of package bad-parts 1.0 raised, seed 3: ValueError: given up; \S+:\d+: raise",
        ),
        (
            "diffusion",
            "newer",
            "diffusion 'newer' of package bad-parts 1.0 asks for version 2 of the contract, .* 1;",
        ),
        ("diffusion", "absent", "diffusion 'absent' of package bad-parts 1.0 cannot be imported"),
        ("choice", "eastwards", "choice 'eastwards' of package bad-parts 1.0 broke its contract, seed 3"),
    ],
)
def test_a_broken_part_is_named_with_its_package(group: str, name: str, said: str) -> None:
    walls = [[0, 1, 0], [0, 0, 0]]
    with pytest.raises(StrategyError, match=said) as caught:
        acoexp.solve(walls, "aco", seed=3, **FEW, **{group: name})  # type: ignore[arg-type]
    assert "\n" not in str(caught.value)


def test_an_object_that_asks_for_a_newer_contract_is_refused_too() -> None:
    from bad_parts import Newer  # type: ignore[import-not-found]

    with pytest.raises(StrategyError, match=r"diffusion 'newer' of package bad-parts 1\.0 asks for version 2"):
        acoexp.solve("env2", "aco", diffusion=Newer())


def test_built_in_parts_and_presets_go_on(caplog: pytest.LogCaptureFixture) -> None:
    result = acoexp.solve("env2", "pdg", **FEW)  # type: ignore[arg-type]
    assert result.algo == "pdg"
    assert "rho" not in find_preset("pdg").values
    assert [message for message in caplog.messages if "bad-parts 1.0 (bad_parts:Newer)" in message]


@pytest.mark.parametrize("name", ["torn", "empty", "misnamed", "partial"])
def test_a_broken_preset_is_named_with_its_package(name: str) -> None:
    assert name in preset_names()
    with pytest.raises(
        StrategyError, match=f"algo '{name}' of package bad-parts 1.0: expected \\S+{name}.yaml to say"
    ):
        find_preset(name)


def test_the_list_of_parts_tells_what_is_broken() -> None:
    text = parts_text()
    broken = {line.split()[0] for line in text.splitlines() if " BROKEN: " in line}
    assert broken >= {"newer", "absent", "torn", "empty", "misnamed", "partial"}
    assert "BROKEN: two packages call a diffusion 'gaussian'" in text
    assert "uncompilable  package bad-parts 1.0, contract 1, bad_parts:Uncompilable" in text
