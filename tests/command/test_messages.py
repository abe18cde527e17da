"""Messages: an error is one line in a person's words, whoever's it was."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hydra.errors import ConfigCompositionException, HydraException
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import InterpolationKeyError

from acoexp.command.messages import in_one_line
from acoexp.errors import SettingsError


def test_a_message_of_ours_stays_as_it_is() -> None:
    assert in_one_line(SettingsError("rho: expected a number; got 'x'")) == "rho: expected a number; got 'x'"


def test_lines_are_joined_and_where_hydra_searched_is_left_out() -> None:
    said = "Could not load 'study/x'.\n\n  It is torn.\n\nConfig search path:\n\tprovider=hydra, path=pkg://hydra.conf"
    assert in_one_line(HydraException(said)) == "Could not load 'study/x'. It is torn."


def test_an_error_that_says_nothing_is_called_by_its_kind() -> None:
    assert in_one_line(TimeoutError()) == "TimeoutError"


@pytest.mark.parametrize(
    ("option", "said"),
    [
        ("hydra/launcher/joblib", 'engine: joblib needs `pip install "acoexp[joblib]"`'),
        ("hydra/launcher/submitit_slurm", 'engine: slurm needs `pip install "acoexp[slurm]"`'),
        ("hydra/launcher/ray", 'engine: ray needs `pip install "acoexp[ray]"`'),
    ],
)
def test_what_comes_with_an_extra_is_told_with_the_command_that_installs_it(option: str, said: str) -> None:
    problem = HydraException(f"In 'engine/x': Could not find '{option}'\n\nAvailable options in 'hydra':\n\tbasic")
    assert in_one_line(problem) == said


@pytest.mark.parametrize(
    ("override", "said"),
    [
        (
            "rhoo=1",
            "rhoo is not a known key; --help lists the keys, --cfg job shows the settings; did you mean rho?",
        ),
        ("hydro=1", "hydro is not a known key; --help lists the keys, --cfg job shows the settings"),
        (
            "map.mooves=free",
            "map.mooves is not a known key; --help lists the keys, --cfg job shows the settings; "
            "did you mean moves?",
        ),
        ("update.elitists=1", "update.elitists is a key of update=elitist, not of update=dual_ant_cycle"),
        (
            "post=geometrik",
            "post: expected one of: geometric, none, shortcut; got 'geometrik'; did you mean geometric?",
        ),
        (
            "map=gaussian",
            "map: expected one of: env1, env2, fig13, file, image, maze, movingai, random, rectangles, rooms, "
            "ros; "
            "got 'gaussian'; there is diffusion=gaussian",
        ),
    ],
)
def test_what_hydra_does_not_know_is_told_with_what_may_have_been_meant(
    override: str, said: str, composed: Callable[..., DictConfig]
) -> None:
    with pytest.raises((HydraException, ConfigCompositionException)) as caught:
        composed(override)
    assert in_one_line(caught.value) == said


def test_an_option_of_a_group_within_a_group_is_told_in_the_same_way(composed: Callable[..., DictConfig]) -> None:
    with pytest.raises(HydraException) as caught:
        composed("hydra/sweeper=optuna", "hydra/sweeper/sampler=tp")
    expected = "hydra/sweeper/sampler: expected one of: cmaes, grid, nsgaii, random, tpe"
    assert in_one_line(caught.value) == f"{expected}; got 'tp'; did you mean tpe?"


@pytest.mark.parametrize(
    ("override", "said"),
    [
        (
            "rho=${nope}",
            "rho: Interpolation key 'nope' not found; where '${' is meant as it stands, type 'rho=\"\\${nope}\"'",
        ),
        (
            "map.path=${nope}",
            "map.path: Interpolation key 'nope' not found; where '${' is meant as it stands, "
            "type 'map.path=\"\\${nope}\"'",
        ),
    ],
)
def test_a_reference_that_leads_nowhere_is_told_with_the_text_that_may_have_been_meant(
    override: str, said: str, composed: Callable[..., DictConfig]
) -> None:
    config = composed("map=file", override)
    with pytest.raises(InterpolationKeyError) as caught:
        OmegaConf.to_container(OmegaConf.masked_copy(config, ["rho", "map"]), resolve=True)
    assert in_one_line(caught.value) == said


def test_what_a_terminal_would_obey_is_escaped() -> None:
    assert in_one_line(HydraException("Could not load '\x1b[31m'")) == "Could not load '\\x1b[31m'"
