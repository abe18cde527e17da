"""Entries: which parts are registered, by whom, and what is said of a name that nobody has."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import EntryPoint, version
from pathlib import Path

import pytest

from acoexp.registry.entries import (
    GROUPS,
    clash,
    entries,
    entry_of,
    is_ours,
    misplaced_entries,
    not_found,
    package_named,
    part_names,
)
from acoexp.strategies.diffusion.gaussian import Gaussian

Install = Callable[..., None]
NO_DIFFUSION = "acoexp.strategies.diffusion.none:NoDiffusion"
GAUSSIAN = "acoexp.strategies.diffusion.gaussian:Gaussian"

BUILT_IN = {
    "heuristic": {"goal_distance", "potential_field"},
    "choice": {"roulette", "acs", "turning"},
    "diffusion": {"none", "gaussian", "luo_wu"},
    "post": {"none", "geometric"},
    "update": {"ant_cycle", "dual_ant_cycle", "elitist", "rank_based", "max_min", "global_best"},
    "map": {"fig13", "env1", "env2", "file"},
    "report": {"compare", "paper"},
}


@pytest.mark.parametrize("group", GROUPS)
def test_the_built_in_parts_are_registered_like_anybodys(group: str) -> None:
    assert set(part_names(group)) >= BUILT_IN[group]


def test_names_are_sorted(install: Install) -> None:
    install(("zephyr", GAUSSIAN), ("breeze", GAUSSIAN))
    assert all(part_names(group) == sorted(part_names(group)) for group in GROUPS)
    assert {"zephyr", "breeze"} <= {*part_names("diffusion")}


def test_a_package_is_known_without_being_imported(install: Install) -> None:
    install(("breeze", "no_such_package_anywhere:Breeze"))
    assert entries("diffusion")["breeze"].value == "no_such_package_anywhere:Breeze"


def test_the_built_in_part_keeps_its_name(install: Install) -> None:
    install(("gaussian", "aaa:First"), ("none", "aaa:First"))
    assert entries("diffusion")["gaussian"].value == GAUSSIAN
    assert is_ours(entries("diffusion")["none"])


def test_a_class_is_found_back_by_where_it_lies() -> None:
    class Other(Gaussian):
        pass

    found = entry_of("diffusion", Gaussian)
    assert found is not None
    assert found.name == "gaussian"
    assert entry_of("post", Gaussian) is None
    assert entry_of("diffusion", Other) is None


def test_a_package_is_named_with_its_version_if_there_is_one() -> None:
    assert package_named(entries("diffusion")["none"]) == f"acoexp {version('acoexp')}"
    assert package_named(EntryPoint("breeze", GAUSSIAN, "acoexp.diffusion")) == "an unknown package"


def test_of_one_name_for_two_parts_both_are_told(install: Install) -> None:
    install(("breeze", NO_DIFFUSION), ("breeze", GAUSSIAN))
    said = clash("diffusion", "breeze")
    assert said is not None
    assert said.startswith("two packages call a diffusion 'breeze': ")
    assert NO_DIFFUSION in said
    assert GAUSSIAN in said


def test_one_part_that_is_seen_twice_is_no_clash(install: Install) -> None:
    install(("breeze", GAUSSIAN), ("breeze", GAUSSIAN))
    assert clash("diffusion", "breeze") is None


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("gausian", "'gausian'; did you mean gaussian?"),
        ("geometric", "'geometric'; there is post=geometric"),
        ("zzz", "'zzz'"),
        (None, "None"),
        (["gausian"], "['gausian']"),
    ],
)
def test_a_name_that_nobody_has_is_refused_with_those_there_are_and_what_may_be_meant(
    name: object, hint: str
) -> None:
    said = not_found("diffusion", name, ["gaussian", "none"])
    assert said == f"diffusion: expected one of: gaussian, none; got {hint}"


def test_a_part_in_a_group_that_does_not_exist_is_told_of_where_it_is_missed(install_package: Install) -> None:
    install_package("lost-parts", "[acoexp.difusion]\nbreeze = lost_parts:Breeze\n", {})
    told = (
        "package lost-parts 1.0 registers breeze under acoexp.difusion, which is no group of acoexp's; "
        "did you mean acoexp.diffusion?"
    )
    assert [said for entry, said in misplaced_entries() if entry.name == "breeze"] == [told]
    assert not_found("diffusion", "breeze", ["none"]).endswith(f"got 'breeze'; {told}")


def test_a_map_that_is_a_file_is_told_how_to_be_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert "map.path" not in not_found("map", "my_map.txt", ["file"])
    for name in ("my_map.txt", "a map"):
        (tmp_path / name).touch()
    assert not_found("map", "my_map.txt", ["file"]).endswith("; for a file: map=file map.path=my_map.txt")
    assert "map.path" not in not_found("map", "a map", ["file"])  # which needs quotes


def test_groups_of_other_programs_are_nobodys_business(install_package: Install) -> None:
    install_package("lost-parts", "[acoexpert.diffusion]\nbreeze = lost_parts:Breeze\n", {})
    assert not [said for entry, said in misplaced_entries() if entry.name == "breeze"]
