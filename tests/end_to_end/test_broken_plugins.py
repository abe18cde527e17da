"""A package that is broken in one way or another: one error that names it, and everything else goes on."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import numba
import pytest
from broken_plugin import ENTRIES, PARTS, PRESETS
from running import install

import acoexp
from acoexp import SettingsError, StrategyError
from acoexp.command.options.listing import parts_text
from acoexp.command.options.registering import UserOptions
from acoexp.registry.entries import _claims, entries
from acoexp.registry.folders import plugin_conf_dirs
from acoexp.registry.parts import _check_unambiguous, _load
from acoexp.registry.presets import find_preset, preset_names

FEW = {"ants": 2, "iterations": 2}


@pytest.fixture(autouse=True)
def broken(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Install a package of broken parts and presets for the length of a test."""
    presets = {f"bad_parts/conf/algo/{name}.yaml": text for name, text in PRESETS.items()}
    install(tmp_path, "bad-parts", ENTRIES, {"bad_parts/__init__.py": PARTS, **presets})
    monkeypatch.syspath_prepend(tmp_path)
    forget()
    yield
    sys.modules.pop("bad_parts", None)
    monkeypatch.undo()
    forget()


def forget() -> None:
    for kept in (entries, _claims, _check_unambiguous, _load, plugin_conf_dirs):
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
            "diffusion 'newer' of package bad-parts 1.0 asks for version 3 of the contract, .* 2;",
        ),
        ("diffusion", "absent", "diffusion 'absent' of package bad-parts 1.0 cannot be imported"),
        pytest.param(
            "diffusion",
            "plain",
            "diffusion 'plain' of package bad-parts 1.0: kernel wander is not @compiled$",
            marks=compiling,
        ),
        (
            "diffusion",
            "misfit",
            r": kernel hesitate takes \(colony, own, cell\); it is called with \(colony, own, ant, cell, came\)$",
        ),
        ("diffusion", "method", r": expected kernel = staticmethod\(stay\)$"),
        ("diffusion", "idle", "bad-parts 1.0: expected Idle to name its kernel"),
        ("diffusion", "undeclared", "bad-parts 1.0: share is a field without parameter()"),
        ("diffusion", "manifold", r"bad-parts 1.0: shares: expected one of the types .* got list\[float\]"),
        ("heuristic", "blind", "heuristic 'blind' of package bad-parts 1.0: expected Blind to define eta"),
        (
            "diffusion",
            "stray",
            r"^most likely diffusion 'stray' of package bad-parts 1.0 \(choice 'roulette' of package acoexp \S+ "
            "is built in\\) broke its contract, seed 3: an ant made moves that are not allowed",
        ),
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

    with pytest.raises(StrategyError, match=r"diffusion 'newer' of package bad-parts 1\.0 asks for version 3"):
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


def test_a_part_that_refuses_its_parameters_is_a_matter_of_settings() -> None:
    with pytest.raises(SettingsError, match=r"^diffusion: ValueError: half is too much; got {'share': 0.5}$"):
        acoexp.solve("env2", "aco", diffusion="picky")


@pytest.mark.parametrize("name", ["torn", "misnamed"])
def test_hydra_gets_no_preset_that_python_would_not_take(name: str, tmp_path: Path) -> None:
    with pytest.raises(StrategyError, match=rf"algo '{name}' of package bad-parts 1.0: .*{name}.yaml"):
        UserOptions("bad-parts", f"options://{tmp_path}/bad_parts/conf").load_config(f"algo/{name}")


def test_what_is_wrong_in_a_preset_is_told_with_its_file() -> None:
    with pytest.raises(
        StrategyError, match=r"^algo 'wrong' of package bad-parts 1.0, \S+wrong.yaml: ants: expected"
    ):
        acoexp.solve("env2", "wrong")
    with pytest.raises(SettingsError, match=r"^rho: expected"):
        acoexp.solve("env2", "wrong", ants=3, rho=2.0)


def test_a_part_in_a_group_that_there_is_not_is_told_of_where_it_is_missed() -> None:
    with pytest.raises(
        SettingsError, match=r"got 'breeze'; package bad-parts 1.0 registers breeze under"
    ) as caught:
        acoexp.solve("env2", "aco", diffusion="breeze")
    assert str(caught.value).endswith("did you mean acoexp.diffusion?")


def test_the_list_of_parts_tells_what_is_broken() -> None:
    text = parts_text()
    broken = {line.split()[0] for line in text.splitlines() if " BROKEN: " in line}
    assert broken >= {"newer", "absent", "torn", "empty", "misnamed", "partial", "idle", "undeclared", "blind"}
    at_its_end = text.partition("== broken ==\n")[2]
    assert "\nBROKEN: diffusion 'idle' of package bad-parts 1.0: " in at_its_end
    assert "BROKEN: package bad-parts 1.0 registers breeze under acoexp.difusion" in at_its_end
    assert "BROKEN: presets of package bad-parts 1.0: expected a package 'no_such_package'" in at_its_end
    assert "BROKEN: two packages call a diffusion 'gaussian'" in text
    assert "uncompilable  package bad-parts 1.0, contract 1, bad_parts:Uncompilable" in text
