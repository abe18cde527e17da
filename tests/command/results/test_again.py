"""The command that runs a job again."""

from __future__ import annotations

import shlex

import pytest

from acoexp.command.results.again import command_of


def test_it_tells_what_the_job_was_told_as_a_shell_takes_it() -> None:
    told = ["algo=pdg", "map=file", "map.path='my map.txt'", "seed=3"]
    assert shlex.split(command_of(told)) == ["python", "-m", "acoexp", *told]


@pytest.mark.parametrize(
    "override",
    ["tracking=none", "tracking.uri=http://me:s3cret@server", "++tracking.uri=x", "threads=2", "resume=false"],
)
def test_where_and_how_it_ran_it_leaves_out(override: str) -> None:
    assert command_of(["seed=3", override]) == "python -m acoexp seed=3"


def test_seeds_stand_as_a_person_writes_them() -> None:
    assert command_of(["seeds='0-9,12'"]) == "python -m acoexp seeds=0-9,12"


def test_it_is_one_line() -> None:
    assert "\n" not in command_of(["map.name=a\nb"])


def test_option_files_of_a_persons_own_are_found_again() -> None:
    said = command_of(["algo=mine"], "my options")
    assert said == "python -m acoexp --config-dir 'my options' algo=mine"
