"""What is kept of a trial, and what makes two trials the same; all without a store."""

from __future__ import annotations

from typing import Any

import pytest

from acoexp import Grid, solve
from acoexp.registry.resolve import resolve
from acoexp.tracking.setup import Setup, Trial, flatten
from acoexp.trial.seeds import parse_seeds

MAP = {"name": "file", "start": None, "path": "yard.txt"}


def setup(algo: str = "pdg", obstacles: Any = ((0, 0), (0, 0)), name: str = "yard", **settings: Any) -> Setup:
    """Return a setup on a map that came from ``MAP``, but for what is said."""
    return Setup(resolve(algo, settings), Grid(obstacles, name=name), MAP)


def test_a_nested_configuration_is_flattened_in_order() -> None:
    config = {"b": {"y": 1.5, "x": {"deep": None}}, "a": [1, 2], "pair": (1, 2), "empty": {}}
    assert list(flatten(config)) == [
        ("b.y", "1.5"), ("b.x.deep", "None"), ("a", "[1, 2]"), ("pair", "[1, 2]"),
    ]  # fmt: skip


def test_params_are_the_resolved_settings_and_where_the_map_came_from() -> None:
    made = setup(rho=1)
    assert made.params == dict(flatten({**made.settings.as_dict(), "map": MAP}))
    assert (made.params["algo"], made.params["rho"], made.params["map.path"]) == ("pdg", "1.0", "yard.txt")
    assert (made.params["diffusion.name"], made.params["diffusion.gamma"]) == ("gaussian", "0.01")
    assert made.params["field.reach"] == "4.0"


def test_a_map_that_came_from_no_source_has_a_name_alone() -> None:
    params = Setup.of(resolve("pdg", {}), Grid(((0, 0), (0, 0)), name="yard")).params
    assert {key: value for key, value in params.items() if key.startswith("map.")} == {"map.name": "yard"}


def test_one_value_has_one_text_however_it_was_given() -> None:
    assert setup(rho=1, tau0=2).params == setup(rho=1.0, tau0=2.0).params


def test_a_trial_has_its_seed_besides() -> None:
    result = solve(Grid(((0, 0), (0, 0))), seed=7, iterations=1, ants=1)
    trial = Trial(setup(), result)
    assert trial.params == {**setup().params, "seed": "7"}
    assert trial.identity == setup().identity(7)


def test_the_algorithm_is_called_what_it_was_and_not_what_it_began_as() -> None:
    assert setup(post="none").params["algo"] == "custom"


def test_two_that_say_the_same_in_other_words_are_one_configuration() -> None:
    said = setup(rho=0.5, diffusion={"name": "gaussian", "gamma": 0.01})
    assert said.configuration_id == setup().configuration_id


@pytest.mark.parametrize(
    "other",
    [
        {"rho": 0.6},
        {"diffusion": {"gamma": 0.02}},
        {"diffusion": "none"},
        {"field": {"reach": 3.0}},
        {"algo": "pd"},
        {"obstacles": ((0, 1), (0, 0))},
        {"name": "garden"},
    ],
    ids=str,
)
def test_whatever_a_result_depends_on_makes_another_configuration(other: dict[str, Any]) -> None:
    assert setup(**other).configuration_id != setup().configuration_id


def test_where_a_map_came_from_does_not_matter() -> None:
    here, there = setup(), Setup.of(setup().settings, setup().grid)
    assert here.configuration_id == there.configuration_id


def test_seeds_tell_trials_and_batches_apart() -> None:
    one, some = parse_seeds("1"), parse_seeds("0-1")
    assert len({setup().identity(seeds) for seeds in (0, 1, one, some)}) == 4
