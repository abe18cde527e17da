"""Parts: from a name to what is registered under it, checked; and one bad package harms nobody else."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from acoexp import SettingsError, StrategyError
from acoexp.registry.entries import part_names
from acoexp.registry.parts import build_part, find_part, key_of_another
from acoexp.registry.resolve import resolve
from acoexp.strategies import Choice, Diffusion, Heuristic, Post, Update
from acoexp.strategies.diffusion.gaussian import Gaussian

Install = Callable[..., None]
NO_DIFFUSION = "acoexp.strategies.diffusion.none:NoDiffusion"
GAUSSIAN = "acoexp.strategies.diffusion.gaussian:Gaussian"


@pytest.mark.parametrize(
    ("group", "kind"),
    [("heuristic", Heuristic), ("choice", Choice), ("diffusion", Diffusion), ("post", Post), ("update", Update)],
)
def test_every_part_is_of_its_groups_kind_and_says_what_it_does(group: str, kind: type) -> None:
    for name in part_names(group):
        part = find_part(group, name)
        assert issubclass(part, kind)
        assert (part.__doc__ or "").strip()


def test_a_part_is_found_by_its_name() -> None:
    assert find_part("diffusion", "gaussian") is Gaussian


def test_an_unknown_name_is_refused_with_those_that_are_known(install: Install) -> None:
    install(("zephyr", NO_DIFFUSION))
    with pytest.raises(SettingsError, match=r"expected one of: gaussian, luo_wu, none.*, zephyr; got 'gausian'"):
        find_part("diffusion", "gausian")


def test_an_installed_package_adds_its_part(install: Install) -> None:
    install(("zephyr", GAUSSIAN))
    assert find_part("diffusion", "zephyr") is Gaussian
    assert resolve("aco", {"diffusion": "zephyr"}).chosen["diffusion"].name == "zephyr"


def test_two_packages_may_not_use_one_name(install: Install) -> None:
    install(("breeze", NO_DIFFUSION), ("breeze", GAUSSIAN))
    with pytest.raises(StrategyError) as caught:
        find_part("diffusion", "breeze")
    message = str(caught.value)
    assert message.startswith("two packages call a diffusion 'breeze': ")
    assert NO_DIFFUSION in message
    assert GAUSSIAN in message


def test_who_takes_a_built_in_name_is_named_and_left_out(
    install: Install, caplog: pytest.LogCaptureFixture
) -> None:
    install(("gaussian", NO_DIFFUSION))
    for _ in range(2):
        assert find_part("diffusion", "gaussian") is Gaussian
    (message,) = caplog.messages
    assert message.startswith("two packages call a diffusion 'gaussian': acoexp 0.1.0 ")
    assert NO_DIFFUSION in message


def test_one_package_seen_twice_is_no_clash(install: Install) -> None:
    """As when a checkout and its wheel are both on the path."""
    install(("breeze", GAUSSIAN), ("breeze", GAUSSIAN))
    assert find_part("diffusion", "breeze") is Gaussian


def test_a_clash_disturbs_nobody_else(install: Install) -> None:
    install(("breeze", NO_DIFFUSION), ("breeze", GAUSSIAN))
    assert "breeze" in part_names("diffusion")
    assert find_part("diffusion", "gaussian") is Gaussian
    assert resolve("pdg", {}).label == "pdg"


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        ("no_such_package_anywhere:Breeze", "ModuleNotFoundError: No module named 'no_such_package_anywhere'"),
        ("acoexp.strategies:Breeze", "AttributeError: "),
        ("broken_breeze:Breeze", "ZeroDivisionError: division by zero"),
    ],
)
def test_a_broken_package_is_named_and_disturbs_nobody_else(
    install: Install, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, value: str, reason: str
) -> None:
    (tmp_path / "broken_breeze.py").write_text("1 / 0\n", encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    install(("breeze", value))
    assert "breeze" in part_names("diffusion")
    assert find_part("diffusion", "gaussian") is Gaussian
    assert resolve("pdg", {}).label == "pdg"
    with pytest.raises(StrategyError) as caught:
        resolve("pdg", {"diffusion": "breeze"})
    assert str(caught.value).startswith("diffusion 'breeze' of package ")
    assert f"cannot be imported from {value}: {reason}" in str(caught.value)
    assert str(caught.value).endswith(f"; {tmp_path}/broken_breeze.py:1: 1 / 0") == value.startswith("broken")


@pytest.mark.parametrize("raised", ["SystemExit(0)", "GeneratorExit()", "BaseException('odd')"])
def test_a_package_that_would_end_the_program_when_it_is_imported_is_broken_like_any_other(
    raised: str, install_package: Install
) -> None:
    install_package("wild-parts", "[acoexp.post]\nending = wild_parts:X\n", {"wild_parts.py": f"raise {raised}\n"})
    with pytest.raises(StrategyError, match=r"post 'ending' of package wild-parts 1\.0 cannot be imported from"):
        find_part("post", "ending")
    assert key_of_another("post", "none", "geometric") is not None


def test_nothing_is_imported_before_it_is_asked_for(
    install: Install, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "lazy_breeze.py").write_text(
        "from acoexp.strategies.diffusion.none import NoDiffusion as Breeze\n", encoding="utf-8"
    )
    monkeypatch.syspath_prepend(tmp_path)
    install(("breeze", "lazy_breeze:Breeze"))
    resolve("pdg", {})
    assert "lazy_breeze" not in sys.modules
    resolve("pdg", {"diffusion": "breeze"})
    assert sys.modules.pop("lazy_breeze").Breeze.__name__ == "NoDiffusion"


@pytest.mark.parametrize("value", ["acoexp.grid:SQRT2", "acoexp.grid:path_length", "acoexp:Grid"])
def test_what_is_registered_as_a_part_must_be_one(install: Install, value: str) -> None:
    install(("breeze", value))
    with pytest.raises(StrategyError, match=r"breeze"):
        resolve("pdg", {"diffusion": "breeze"})


def test_a_part_is_built_from_checked_parameters() -> None:
    assert build_part("diffusion", "gaussian", {"gamma": 0.5}) == Gaussian(gamma=0.5)
    with pytest.raises(SettingsError, match=r"^diffusion\.gamma: expected a number from 0 to 1; got 5"):
        build_part("diffusion", "gaussian", {"gamma": 5})


def test_a_key_of_another_part_is_told_from_one_that_nobody_has() -> None:
    whose = "diffusion.gamma is a key of diffusion=gaussian and diffusion=luo_wu, not of diffusion=none"
    assert key_of_another("diffusion", "none", "gamma") == whose
    assert key_of_another("diffusion", "none", "nope") is None
    with pytest.raises(SettingsError, match=rf"^{whose}$"):
        build_part("diffusion", "none", {"gamma": 0.5})
