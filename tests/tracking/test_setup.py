"""What is kept of a trial, and what makes two trials the same; all without a store."""

from __future__ import annotations

from typing import Any

import pytest

from acoexp import Grid, solve
from acoexp.registry.resolve import resolve
from acoexp.tracking.setup import Setup, Trial, flatten
from acoexp.trial.seeds import parse_seeds

CONFIG = {
    "algo": "pdg",
    "seed": 3,
    "seeds": None,
    "threads": 2,
    "resume": True,
    "rho": 0.5,
    "map": {"name": "file", "start": None, "path": "yard.txt"},
    "diffusion": {"name": "gaussian", "gamma": 0.01},
    "tracking": {"name": "mlflow", "uri": "http://user:secret@server"},
    "report": {"name": "none"},
}


def setup(algo: str = "pdg", obstacles: Any = ((0, 0), (0, 0)), name: str = "yard", **settings: Any) -> Setup:
    """Return a setup that came from ``CONFIG``, but for what is said."""
    return Setup(resolve(algo, settings), Grid(obstacles, name=name), CONFIG)


def test_a_nested_configuration_is_flattened_in_order() -> None:
    config = {"b": {"y": 1.5, "x": {"deep": None}}, "a": [1, 2]}
    assert list(flatten(config)) == [("b.y", "1.5"), ("b.x.deep", "None"), ("a", "[1, 2]")]


def test_params_are_what_the_result_depends_on() -> None:
    assert setup().params == {
        "algo": "pdg", "rho": "0.5", "map.name": "file", "map.start": "None", "map.path": "yard.txt",
        "diffusion.name": "gaussian", "diffusion.gamma": "0.01",
    }  # fmt: skip


def test_a_trial_has_its_seed_besides() -> None:
    result = solve(Grid(((0, 0), (0, 0))), seed=7, iterations=1, ants=1)
    trial = Trial(setup(), result)
    assert trial.params == {**setup().params, "seed": "7"}
    assert trial.identity == setup().identity(7)


def test_a_password_in_the_stores_address_is_in_no_param() -> None:
    assert "secret" not in str(setup().params)


def test_the_algorithm_is_called_what_it_was_and_not_what_it_began_as() -> None:
    assert setup(post="none").params["algo"] == "custom"


def test_without_a_configuration_the_settings_themselves_are_the_params() -> None:
    params = Setup.of(resolve("pdg", {"rho": 0.25}), Grid(((0, 0), (0, 0)), name="yard")).params
    assert (params["algo"], params["rho"], params["map.name"]) == ("pdg", "0.25", "yard")
    assert (params["diffusion.name"], params["diffusion.gamma"]) == ("gaussian", "0.01")
    assert params["field.reach"] == "4.0"


def test_two_that_say_the_same_in_other_words_are_one_cell() -> None:
    assert (
        setup(rho=0.5, diffusion={"name": "gaussian", "gamma": 0.01}).configuration_id == setup().configuration_id
    )


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
def test_whatever_a_result_depends_on_makes_another_cell(other: dict[str, Any]) -> None:
    assert setup(**other).configuration_id != setup().configuration_id


def test_seeds_tell_trials_and_batches_apart() -> None:
    one, some = parse_seeds("1"), parse_seeds("0-1")
    assert len({setup().identity(seeds) for seeds in (0, 1, one, some)}) == 4
