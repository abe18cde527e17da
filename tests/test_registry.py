"""The registry: the built-in parts stand beside anybody's, and one bad package harms nobody else."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from importlib import metadata
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from acoexp import SettingsError, StrategyError, registry
from acoexp.settings import resolve
from acoexp.strategies import Choice, Diffusion, Heuristic, Post, Update
from acoexp.strategies.diffusion.gaussian import Gaussian

Install = Callable[..., None]
NO_DIFFUSION = "acoexp.strategies.diffusion.none:NoDiffusion"
GAUSSIAN = "acoexp.strategies.diffusion.gaussian:Gaussian"


@pytest.fixture
def install(monkeypatch: pytest.MonkeyPatch) -> Iterator[Install]:
    """Return a function that adds diffusions, each as name=value, to the packages that are installed."""

    def forget() -> None:
        for kept in (registry.entries, registry._claims, registry._settle, registry._load):
            kept.cache_clear()

    def pretend(*added: tuple[str, str]) -> None:
        installed = metadata.entry_points
        new = [EntryPoint(name, value, "acoexp.diffusion") for name, value in added]

        def entry_points(group: str) -> list[EntryPoint]:
            return [*installed(group=group), *(entry for entry in new if entry.group == group)]

        monkeypatch.setattr(registry, "entry_points", entry_points)
        forget()

    yield pretend
    monkeypatch.undo()
    forget()


BUILT_IN = {
    "heuristic": {"goal_distance", "potential_field"},
    "choice": {"roulette"},
    "diffusion": {"none", "gaussian", "luo_wu"},
    "post": {"none", "geometric"},
    "update": {"ant_cycle", "dual_ant_cycle"},
    "map": {"fig13", "env1", "env2", "file"},
}


@pytest.mark.parametrize("group", BUILT_IN)
def test_the_built_in_parts_are_registered_like_anybodys(group: str) -> None:
    assert set(registry.names(group)) >= BUILT_IN[group]


@pytest.mark.parametrize("group", registry.GROUPS)
def test_names_are_sorted(group: str) -> None:
    assert registry.names(group) == sorted(registry.names(group))


@pytest.mark.parametrize(
    ("group", "kind"),
    [("heuristic", Heuristic), ("choice", Choice), ("diffusion", Diffusion), ("post", Post), ("update", Update)],
)
def test_every_part_is_of_its_groups_kind_and_says_what_it_does(group: str, kind: type) -> None:
    for name in BUILT_IN[group]:
        part = registry.find(group, name)
        assert issubclass(part, kind)
        assert (part.__doc__ or "").strip()


def test_a_part_is_found_by_its_name() -> None:
    assert registry.find("diffusion", "gaussian") is Gaussian


def test_an_unknown_name_is_refused_with_those_that_are_known(install: Install) -> None:
    install(("zephyr", NO_DIFFUSION))
    with pytest.raises(SettingsError, match=r"expected one of: gaussian, luo_wu, none.*, zephyr; got 'gausian'"):
        registry.find("diffusion", "gausian")


def test_an_installed_package_adds_its_part(install: Install) -> None:
    install(("zephyr", GAUSSIAN))
    assert registry.find("diffusion", "zephyr") is Gaussian
    assert resolve("aco", {"diffusion": "zephyr"}).names["diffusion"] == "zephyr"


def test_two_packages_may_not_use_one_name(install: Install) -> None:
    install(("breeze", NO_DIFFUSION), ("breeze", GAUSSIAN))
    with pytest.raises(StrategyError) as caught:
        registry.find("diffusion", "breeze")
    message = str(caught.value)
    assert message.startswith("two packages call a diffusion 'breeze': ")
    assert NO_DIFFUSION in message
    assert GAUSSIAN in message


def test_who_takes_a_built_in_name_is_named_and_left_out(
    install: Install, caplog: pytest.LogCaptureFixture
) -> None:
    install(("gaussian", NO_DIFFUSION))
    for _ in range(2):
        assert registry.find("diffusion", "gaussian") is Gaussian
    (message,) = caplog.messages
    assert message.startswith("two packages call a diffusion 'gaussian': acoexp 0.1.0 ")
    assert NO_DIFFUSION in message


def test_one_package_seen_twice_is_no_clash(install: Install) -> None:
    """As when a checkout and its wheel are both on the path."""
    install(("breeze", GAUSSIAN), ("breeze", GAUSSIAN))
    assert registry.find("diffusion", "breeze") is Gaussian


def test_a_clash_disturbs_nobody_else(install: Install) -> None:
    install(("breeze", NO_DIFFUSION), ("breeze", GAUSSIAN))
    assert "breeze" in registry.names("diffusion")
    assert registry.find("diffusion", "gaussian") is Gaussian
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
    assert "breeze" in registry.names("diffusion")
    assert registry.find("diffusion", "gaussian") is Gaussian
    assert resolve("pdg", {}).label == "pdg"
    with pytest.raises(StrategyError) as caught:
        resolve("pdg", {"diffusion": "breeze"})
    assert str(caught.value).startswith("diffusion 'breeze' of package ")
    assert f"cannot be imported from {value}: {reason}" in str(caught.value)
    assert str(caught.value).endswith(f"; {tmp_path}/broken_breeze.py:1: 1 / 0") == value.startswith("broken")


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
