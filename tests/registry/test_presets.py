"""Presets: the four algorithms as combinations of parts, in files that Python and Hydra both read."""

from __future__ import annotations

import pytest

from acoexp import SettingsError
from acoexp.registry.folders import conf_dir
from acoexp.registry.parts import find_part
from acoexp.registry.presets import find_preset, preset_names
from acoexp.registry.resolve import resolve
from acoexp.strategies.groups import STRATEGY_GROUPS

TABLE = {
    #       heuristic          choice      diffusion   post         update
    "aco": ("goal_distance", "roulette", "none", "none", "ant_cycle"),
    "pd": ("goal_distance", "roulette", "gaussian", "none", "ant_cycle"),
    "pdg": ("goal_distance", "roulette", "gaussian", "geometric", "dual_ant_cycle"),
    "pf": ("potential_field", "roulette", "luo_wu", "none", "ant_cycle"),
    "eas": ("goal_distance", "roulette", "none", "none", "elitist"),
    "rank": ("goal_distance", "roulette", "none", "none", "rank_based"),
    "mmas": ("goal_distance", "roulette", "none", "none", "max_min"),
    "acs": ("goal_distance", "acs", "none", "none", "global_best"),
    "nav": ("coarse", "roulette", "none", "shortcut", "rank_based"),
}


def test_there_are_the_papers_algorithms_the_classical_ones_and_one_for_real_maps() -> None:
    assert preset_names() == sorted(TABLE)


@pytest.mark.parametrize("algo", TABLE)
def test_an_algorithm_is_a_combination_of_parts(algo: str) -> None:
    assert tuple(find_preset(algo).parts[group] for group in STRATEGY_GROUPS) == TABLE[algo]


@pytest.mark.parametrize("algo", TABLE)
def test_a_preset_resolves_to_its_own_parts_and_label(algo: str) -> None:
    settings = resolve(algo, {})
    assert settings.label == algo
    assert tuple(one.name for one in settings.chosen.values()) == TABLE[algo]
    for group, part in settings.parts.items():
        assert type(part) is find_part(group, settings.chosen[group].name)


@pytest.mark.parametrize("algo", TABLE)
def test_a_preset_says_in_one_line_what_it_is(algo: str) -> None:
    preset = find_preset(algo)
    assert preset.name == algo
    assert len(preset.summary) > 20
    assert not preset.summary.startswith(("@", "#"))


def test_an_unknown_algorithm_is_refused_with_those_that_are_known() -> None:
    with pytest.raises(SettingsError) as caught:
        find_preset("nope")
    assert str(caught.value) == "algo: expected one of: aco, acs, eas, mmas, nav, pd, pdg, pf, rank; got 'nope'"


def test_presets_are_hydras_own_files() -> None:
    assert {path.stem for path in (conf_dir() / "algo").glob("*.yaml")} == set(TABLE)
