"""Resolving: every way to say a part, what overrides what, how a result is labelled, whose fault an error is."""

from __future__ import annotations

from dataclasses import dataclass, replace
from importlib.metadata import version
from typing import Any

import numpy as np
import pytest

from acoexp import SettingsError, StrategyError
from acoexp.registry.presets import find_preset
from acoexp.registry.resolve import resolve
from acoexp.strategies import Choice, Diffusion, Heuristic, Post, Update
from acoexp.strategies.choice.roulette import Roulette
from acoexp.strategies.diffusion.gaussian import Gaussian
from acoexp.strategies.diffusion.luo_wu import LuoWu
from acoexp.strategies.diffusion.none import NoDiffusion
from acoexp.strategies.heuristic.goal_distance import GoalDistance
from acoexp.strategies.post.none import NoPost
from acoexp.strategies.update.ant_cycle import AntCycle
from acoexp.trial.seeds import check_seed
from acoexp.trial.settings import Settings


@dataclass(frozen=True)
class HomeMade(Diffusion):
    """A part made in a notebook, of no package."""

    kernel = staticmethod(NoDiffusion.kernel)


def refusal(algo: Any = "pdg", **values: Any) -> str:
    """Return the message with which settings are refused."""
    with pytest.raises(SettingsError) as caught:
        resolve(algo, values)
    return str(caught.value)


def diffusion_of(algo: str, given: Any) -> tuple[str, str, Any]:
    """Return label, name and part when a diffusion is given."""
    settings: Settings = resolve(algo, {"diffusion": given})
    return settings.label, settings.chosen["diffusion"].name, settings.parts["diffusion"]


def test_nothing_said_means_the_defaults_of_the_paper() -> None:
    scalars = resolve("pdg", {}).scalars
    assert (scalars.alpha, scalars.beta, scalars.rho) == (1.1, 12.0, 0.5)
    assert (scalars.ants, scalars.iterations, scalars.q, scalars.tau0) == (10, 200, 1.0, 1.0)


def test_scalars_are_overridden_one_by_one() -> None:
    scalars = resolve("aco", {"ants": 5, "rho": 0.25}).scalars
    assert (scalars.ants, scalars.rho, scalars.beta) == (5, 0.25, 12.0)


def test_numpy_scalars_are_numbers() -> None:
    scalars = resolve("aco", {"ants": np.int32(5), "rho": np.float32(0.25), "alpha": np.int64(2)}).scalars
    assert (scalars.ants, scalars.rho, scalars.alpha) == (5, 0.25, 2.0)
    assert [type(scalars.ants), type(scalars.rho), type(scalars.alpha)] == [int, float, float]


@pytest.mark.parametrize(
    ("key", "value"),
    [("ants", 0), ("ants", 2.0), ("ants", True), ("iterations", 0), ("rho", 1.5), ("rho", -0.1), ("alpha", np.nan),
     ("beta", np.inf), ("q", 0.0), ("tau0", 0), ("tau0", "1"), ("alpha", None), ("beta", "???"),
     ("pheromone", "nodes"), ("order", "lockstep")],
)  # fmt: skip
def test_scalars_out_of_range_are_refused(key: str, value: Any) -> None:
    assert refusal(**{key: value}).startswith(f"{key}: expected ")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"pheromone": "nodes"}, "pheromone: expected one of: edges, cells; got 'nodes'"),
        ({"order": "random"}, "order: expected one of: in_turn, lock_step, two_ended; got 'random'"),
        ({"field": {"obstacles": "all"}}, "field.obstacles: expected one of: sum, nearest; got 'all'"),
        (
            {"diffusion": {"source": "cell"}},
            "diffusion.source: expected one of: force_edge, walked_edge, sum_in, mean_out, max_out; got 'cell'",
        ),
    ],
)
def test_a_reading_of_the_paper_that_there_is_not_is_refused_with_those_there_are(
    values: dict[str, Any], message: str
) -> None:
    assert refusal("pdg", **values) == refusal("pf", **values) == message


def test_an_unknown_key_is_refused_with_those_that_are_known() -> None:
    message = refusal(gama=0.1)
    assert message.startswith(
        "gama is not a known key; expected one of: alpha, ants, beta, choice, dead_end, diffusion, "
    )


@pytest.mark.parametrize("algo", ["PDG", "", None, 5, "custom", "../algo/pdg"])
def test_an_unknown_algorithm_is_refused(algo: Any) -> None:
    assert refusal(algo) == f"algo: expected one of: aco, acs, eas, mmas, nav, pd, pdg, pf, rank; got {algo!r}"


def test_a_part_may_be_a_name() -> None:
    assert diffusion_of("aco", "gaussian") == ("custom", "gaussian", Gaussian())


def test_a_part_may_be_a_mapping_with_its_name() -> None:
    assert diffusion_of("aco", {"name": "gaussian", "gamma": 0.02}) == ("custom", "gaussian", Gaussian(gamma=0.02))


def test_a_mapping_without_name_changes_the_presets_own_part() -> None:
    assert diffusion_of("pd", {"gamma": 0.02}) == ("pd", "gaussian", Gaussian(gamma=0.02))
    assert diffusion_of("pd", {}) == ("pd", "gaussian", Gaussian())
    said = "diffusion.gamma is a key of diffusion=gaussian and diffusion=luo_wu, not of diffusion=none"
    assert refusal("aco", diffusion={"gamma": 0.02}) == said


def test_what_a_preset_says_of_a_part_holds_until_a_part_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    pd = find_preset("pd")
    strong = replace(pd, values={"ants": 3, "diffusion": {"gamma": 0.5}})
    monkeypatch.setattr("acoexp.registry.resolve.find_preset", lambda algo: strong)
    assert resolve("pd", {}).scalars.ants == 3
    assert resolve("pd", {"ants": 4}).scalars.ants == 4
    assert diffusion_of("pd", {}) == ("pd", "gaussian", Gaussian(gamma=0.5))
    assert diffusion_of("pd", {"name": "luo_wu"}) == ("custom", "luo_wu", LuoWu())


def test_what_is_wrong_in_a_preset_is_the_presets_fault_and_what_a_user_says_the_users(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    faulty = replace(find_preset("pd"), values={"ants": 0})
    monkeypatch.setattr("acoexp.registry.resolve.find_preset", lambda algo: faulty)
    with pytest.raises(StrategyError, match=r"^algo 'pd' of package acoexp .*pd\.yaml: ants: expected .* got 0$"):
        resolve("pd", {})
    assert refusal("pd", ants=3, rho=2.0) == "rho: expected a number from 0 to 1; got 2.0"
    assert resolve("pd", {"ants": 3}).scalars.ants == 3


def test_each_part_knows_the_package_that_registers_it() -> None:
    chosen = resolve("aco", {"diffusion": Gaussian(), "update": "elitist"}).chosen
    assert {one.package for one in chosen.values()} == {f"acoexp {version('acoexp')}"}
    assert resolve("aco", {"diffusion": HomeMade()}).chosen["diffusion"].package is None


def test_a_part_may_be_an_object() -> None:
    assert diffusion_of("aco", Gaussian(gamma=0.5)) == ("custom", "gaussian", Gaussian(gamma=0.5))


def test_a_part_of_no_package_is_called_like_its_class() -> None:
    assert diffusion_of("aco", HomeMade()) == ("custom", "HomeMade", HomeMade())


@pytest.mark.parametrize("given", ["gaussian", {"name": "gaussian"}, {"gamma": 0.5}, Gaussian(gamma=0.5)])
def test_the_label_stays_where_no_parts_name_differs(given: Any) -> None:
    assert diffusion_of("pdg", given)[0] == "pdg"


@pytest.mark.parametrize(
    "given", [{"diffusion": "none"}, {"post": "none"}, {"update": AntCycle()}, {"heuristic": "potential_field"}]
)
def test_the_label_is_custom_where_a_part_was_replaced(given: dict[str, Any]) -> None:
    assert resolve("pdg", given).label == "custom"


def test_scalars_and_field_leave_the_label_alone() -> None:
    settings = resolve("pdg", {"ants": 5, "field": {"reach": 2}})
    assert (settings.label, settings.field.reach, settings.field.repulsion) == ("pdg", 2.0, 25.0)


def test_parts_not_spoken_of_are_the_presets() -> None:
    settings = resolve("pdg", {"diffusion": "none"})
    assert settings.chosen["post"].name == "geometric"
    assert settings.chosen["update"].name == "dual_ant_cycle"


@pytest.mark.parametrize("group", ["heuristic", "choice", "diffusion", "post", "update"])
@pytest.mark.parametrize("odd", [5, None, ["gaussian"], Gaussian, object()])
def test_a_part_is_a_name_a_mapping_or_an_object_of_its_kind(group: str, odd: Any) -> None:
    message = refusal(**{group: odd})
    assert message == (
        f"{group}: expected a mapping of parameters, a name or a {group.capitalize()} object; got {odd!r}"
    )


KINDS = {Heuristic: GoalDistance(), Choice: Roulette(), Diffusion: Gaussian(), Post: NoPost(), Update: AntCycle()}


@pytest.mark.parametrize("kind", KINDS)
def test_an_object_of_another_kind_is_refused(kind: type) -> None:
    for other, part in KINDS.items():
        if other is not kind:
            assert "expected a mapping" in refusal(**{kind.__name__.lower(): part})


@pytest.mark.parametrize("given", ["gausian", {"name": "gausian"}, {"name": "gausian", "gamma": 0.1}])
def test_an_unknown_part_is_refused_with_those_that_are_known(given: Any) -> None:
    message = refusal(diffusion=given)
    assert message.startswith("diffusion: expected one of: gaussian, luo_wu, none")
    assert message.endswith("; got 'gausian'; did you mean gaussian?")


def test_a_parts_parameters_are_checked() -> None:
    assert refusal(diffusion={"gamma": 1.5}) == "diffusion.gamma: expected a number from 0 to 1; got 1.5"
    assert refusal(diffusion={"gama": 1}).startswith("diffusion.gama is not a known key; expected one of: ")


def test_the_field_is_a_mapping_of_its_constants() -> None:
    assert refusal(field=5) == "field: expected a mapping of parameters; got 5"
    assert refusal(field={"reach": 0}) == "field.reach: expected a number above 0; got 0"
    assert refusal(field={"gain": 0}).startswith("field.gain is not a known key")


@pytest.mark.parametrize("odd", [["pdg"], {"name": "pdg"}])
def test_an_algorithm_is_a_name(odd: Any) -> None:
    assert refusal(odd).endswith(f"got {odd!r}")


@pytest.mark.parametrize("odd", [["gaussian"], {}, 5, None])
def test_a_parts_name_is_a_text(odd: Any) -> None:
    assert refusal(diffusion={"name": odd}).endswith(f"got {odd!r}")


@pytest.mark.parametrize("seed", [0, 2**64 - 1, np.int8(7), np.uint64(2**64 - 1)])
def test_a_seed_is_a_whole_number_of_64_bits(seed: Any) -> None:
    assert check_seed(seed) == int(seed)
    assert type(check_seed(seed)) is int


@pytest.mark.parametrize("seed", [-1, 2**64, 1.0, np.float64(1), "1", None, True, np.True_, np.array([1])])
def test_anything_else_is_no_seed(seed: Any) -> None:
    with pytest.raises(SettingsError) as caught:
        check_seed(seed)
    assert str(caught.value) == f"seed: expected a whole number from 0 to 2^64 - 1; got {seed!r}"
