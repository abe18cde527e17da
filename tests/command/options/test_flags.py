"""Flags: what Hydra's own parser knows of them. Whatever here fails with another Hydra, acoexp relies on."""

from __future__ import annotations

import hydra
import pytest
from hydra._internal.utils import get_args_parser

from acoexp.command.options.flags import (
    complete_past_flags,
    flags_parser,
    split_arguments,
    without_config_dir,
)
from acoexp.errors import SettingsError

TAKES_A_VALUE = {
    ("--config-dir", "-cd"): True,
    ("--config-path", "-cp"): True,
    ("--config-name", "-cn"): True,
    ("--experimental-rerun",): True,
    ("--cfg", "-c"): True,
    ("--package", "-p"): True,
    ("--multirun", "-m"): False,
    ("--run", "-r"): False,
    ("--resolve",): False,
    ("--shell-completion", "-sc"): False,
    ("--help", "-h"): False,
    ("--hydra-help",): False,
}
"""The flags of Hydra 1.3, but for ``--info``, which may have a value, and ``--version``."""


def split(*argv: str) -> tuple[list[str], list[str]]:
    """Return overrides and flags apart."""
    return split_arguments(list(argv), flags_parser())


def test_it_is_written_for_this_hydra() -> None:
    assert hydra.__version__.startswith("1.3.")


@pytest.mark.parametrize(("names", "takes"), TAKES_A_VALUE.items(), ids=lambda names: str(names))
def test_hydra_has_each_flag_and_it_takes_a_value_or_none(names: tuple[str, ...], takes: bool) -> None:
    for name in names:
        said = [name, "job"] if takes else [name]
        given = vars(get_args_parser().parse_args(said))
        assert given[names[0].lstrip("-").replace("-", "_")] == ("job" if takes else True)
        with pytest.raises(SystemExit):
            get_args_parser().parse_args([name] if takes else [f"{names[0]}=job"])


def test_hydra_has_no_other_flag() -> None:
    known = {name for action in get_args_parser()._actions for name in action.option_strings}
    assert known == {name for names in TAKES_A_VALUE for name in names} | {"--info", "-i", "--version"}


@pytest.mark.parametrize(("said", "shown"), [(["--info"], "all"), (["-i", "defaults"], "defaults"), ([], None)])
def test_info_may_have_a_value(said: list[str], shown: str | None) -> None:
    assert get_args_parser().parse_args(said).info == shown


@pytest.mark.parametrize("names", TAKES_A_VALUE, ids=str)
def test_a_flag_is_told_from_an_override_on_either_side_of_it(names: tuple[str, ...]) -> None:
    for name in names:
        flag = [name, "job"] if TAKES_A_VALUE[names] else [name]
        assert split("a=1", *flag, "b=2") == (["a=1", "b=2"], flag)


def test_info_takes_what_it_can_show_and_nothing_else() -> None:
    assert split("--info", "a=1") == (["a=1"], ["--info"])
    assert split("--info", "defaults", "a=1") == (["a=1"], ["--info", "defaults"])
    assert split("--info", "strategies", "a=1") == (["a=1"], ["--info", "strategies"])


@pytest.mark.parametrize(
    ("written", "flag"),
    [("--config-d", "--config-dir"), ("--mult", "--multirun"), ("--config-", "--config-"), ("--", "--")],
)
def test_a_flag_may_be_shortened_as_long_as_one_alone_begins_like_that(written: str, flag: str) -> None:
    assert split(written)[1] == [flag]


def test_the_parser_knows_a_list_that_hydra_does_not() -> None:
    assert flags_parser().parse_args(["--info", "strategies"]).info == "strategies"
    with pytest.raises(SystemExit):
        get_args_parser().parse_args(["--info", "strategies"])


@pytest.mark.parametrize("wrong", [["--nope"], ["--info", "nope"], ["--info=nope"], ["--cfg"], ["--cfg", "nope"]])
def test_what_is_no_flag_is_refused_in_one_line(wrong: list[str]) -> None:
    with pytest.raises(SettingsError, match=r"; --help lists what there is$") as caught:
        flags_parser().parse_args(wrong)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "folder", [["--config-dir", "mine"], ["-cd", "mine"], ["--config-dir=mine"], ["-cd=mine"]]
)
def test_the_users_folder_is_taken_out_with_its_value(folder: list[str]) -> None:
    assert without_config_dir(["-m", *folder, "--cfg", "job"]) == ["-m", "--cfg", "job"]


@pytest.mark.parametrize(
    ("line", "completed"),
    [
        ("acoexp -m map=en", "acoexp map=en"),
        ("acoexp algo=pd --multirun map=en", "acoexp algo=pd map=en"),
        ("acoexp map.path=-m se", "acoexp map.path=-m se"),
        ("acoexp -m", "acoexp -m"),
        ("acoexp map=en", "acoexp map=en"),
    ],
)
def test_a_shell_completes_behind_m_as_if_it_was_not_there(line: str, completed: str) -> None:
    environment = {"COMP_LINE": line, "COMP_POINT": str(len(line)), "HOME": "/"}
    complete_past_flags(environment)
    assert environment == {"COMP_LINE": completed, "COMP_POINT": str(len(completed)), "HOME": "/"}


def test_outside_of_a_completion_nothing_is_changed() -> None:
    environment = {"HOME": "/"}
    complete_past_flags(environment)
    assert environment == {"HOME": "/"}
