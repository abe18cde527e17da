"""What each job of a sweep is told."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.errors import HydraException
from omegaconf import DictConfig, OmegaConf

from acoexp.command.sweep.told import as_written, combinations, has_references


def parsed(*overrides: str) -> list[Any]:
    """Return overrides as Hydra reads them."""
    return OverridesParser.create().parse_overrides(list(overrides))


def test_each_job_is_told_one_value_of_each_key_the_last_keys_changing_fastest() -> None:
    assert combinations(parsed("algo=aco,pd", "rho=0.5", "seed=0,1")) == [
        ["algo=aco", "rho=0.5", "seed=0"],
        ["algo=aco", "rho=0.5", "seed=1"],
        ["algo=pd", "rho=0.5", "seed=0"],
        ["algo=pd", "rho=0.5", "seed=1"],
    ]


@pytest.mark.parametrize(
    ("written", "values"),
    [
        ("rho=choice(0.1,0.2)", ["rho=0.1", "rho=0.2"]),
        ("ants=range(1,4)", ["ants=1", "ants=2", "ants=3"]),
        ("diffusion.gamma=choice(0.5)", ["diffusion.gamma=0.5"]),
        ("map.path='a,b'", ["map.path='a,b'"]),
        ("+study=slow,wide", ["+study=slow", "+study=wide"]),
    ],
)
def test_values_are_written_as_hydra_reads_them_again(written: str, values: list[str]) -> None:
    assert [told for (told,) in combinations(parsed(written))] == values


def test_without_anything_to_choose_there_is_one_job() -> None:
    assert combinations([]) == [[]]
    assert combinations(parsed("rho=0.5")) == [["rho=0.5"]]


def test_of_a_key_that_is_said_twice_the_last_word_counts() -> None:
    assert combinations(parsed("rho=0.1,0.2", "ants=3", "rho=0.5")) == [["rho=0.5", "ants=3"]]


@pytest.mark.parametrize("interval", ["rho=interval(0.1,0.9)", "rho=tag(fast,interval(0,1))"])
def test_an_interval_is_only_for_an_optimiser(interval: str) -> None:
    with pytest.raises(HydraException, match=r"^rho=.*: expected values or a range, .*another hydra/sweeper"):
        combinations(parsed(interval))


def test_what_only_a_job_knows_stays_as_it_was_written() -> None:
    config = OmegaConf.create({"texts": ["hydra.sweep.subdir=${hydra.job.num}", "rho=0.5"]})
    assert as_written(config.texts) == ["hydra.sweep.subdir=${hydra.job.num}", "rho=0.5"]


@pytest.mark.parametrize(
    ("overrides", "refers"),
    [
        ((), False),
        (("map=random", "map.seed=${seed}"), True),
        (("map=random", "map.seed=3"), False),
        (("tracking.uri='http://me:${seed}@host'",), True),
    ],
)
def test_references_are_known(
    overrides: tuple[str, ...], refers: bool, composed: Callable[..., DictConfig]
) -> None:
    assert has_references(composed(*overrides)) is refers
