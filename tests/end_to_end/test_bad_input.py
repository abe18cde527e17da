"""Bad input: one line that says what was expected and what came, status 1, nothing written.

The command is tried with one input of each kind; the rest are given to the same check without a process.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from hydra import compose, initialize_config_dir
from hydra.errors import HydraException
from omegaconf.errors import OmegaConfBaseException
from running import QUICK, refusal, run_acoexp

from acoexp.command.handover import Handover
from acoexp.command.job import Job, plain
from acoexp.command.messages import in_one_line
from acoexp.command.options.registering import register_options
from acoexp.errors import AcoexpError
from acoexp.registry.folders import conf_dir


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("algo=nope", "algo: expected one of: aco, acs, eas, mmas, nav, pd, pdg, pf, rank; got 'nope'"),
        ("diffusion=nope", "diffusion: expected one of: gaussian, luo_wu, none; got 'nope'"),
        (
            "map=nope",
            "map: expected one of: env1, env2, fig13, file, image, maze, movingai, random, rectangles, rooms, "
            "ros; got 'nope'",
        ),
        ("nope=1", "nope is not a known key"),
        ("+diffusion.nope=1", "diffusion.nope is not a known key; expected one of: diffusion.gamma"),
        ("ants=abc", "ants: expected a whole number from 1 to 100000; got 'abc'"),
        ("rho=1.5", "rho: expected a number from 0 to 1; got 1.5"),
        ("seed=-1", "seed: expected a whole number from 0 to 2^64 - 1; got -1"),
        ("seed=0-9", "seed=0-9: several values; add -m"),
        ("seed", "'seed'"),
        # what Hydra does not word for a person
        ("~seed", "seed"),
        ("~algo", "algo"),
        ("algo=null", "algo: expected one of the options"),
        ("=3", "=3: expected key=value"),
    ],
)
def test_a_bad_setting_is_refused(given: str, said: str, tmp_path: Path) -> None:
    assert said in refusal(given, cwd=tmp_path)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("rho=0.3,1.5", "rho: expected a number from 0 to 1; got 1.5"),
        ("seed=1,2,x", "seed: expected a whole number from 0 to 2^64 - 1; got 'x'"),
        (
            "seed=1,18446744073709551616",
            "seed: expected a whole number from 0 to 2^64 - 1; got 18446744073709551616",
        ),
        ("seed=1,01", "seed: expected a whole number from 0 to 2^64 - 1; got '01'"),
        ("post=none,nope", "post: expected one of: geometric, none, shortcut; got 'nope'"),
    ],
)
def test_one_bad_value_among_good_ones_stops_a_sweep_before_its_first_job(
    given: str, said: str, tmp_path: Path
) -> None:
    assert refusal(given, *QUICK, "-m", cwd=tmp_path) == said


def test_flags_that_exclude_each_other_are_refused(tmp_path: Path) -> None:
    assert "--multirun" in refusal("-m", "--cfg", "job", cwd=tmp_path)


def test_a_map_without_a_way_is_told_from_an_ants_failure(tmp_path: Path) -> None:
    (tmp_path / "yard.txt").write_text("...\n###\n...\n", encoding="utf-8")
    said = "map yard.txt: no way leads from start (0, 0) to goal (2, 2)"
    assert refusal("map=file", "map.path=yard.txt", cwd=tmp_path).startswith(said)


@pytest.mark.parametrize("mode", [(), ("-m", "seed=0,1")])
def test_outputs_that_are_no_folder_are_refused(mode: tuple[str, ...], tmp_path: Path) -> None:
    (tmp_path / "outputs").write_text("I am no folder\n", encoding="utf-8")
    assert "outputs" in refusal(*QUICK, *mode, cwd=tmp_path)


@pytest.mark.parametrize(
    ("uri", "said"), [("sqlite:///blocked/x.db", "blocked"), ("nope://there", "nope://there")]
)
def test_a_store_that_cannot_be_written_is_refused(uri: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "blocked").write_text("I am no folder\n", encoding="utf-8")
    message = refusal("iterations=3", f"tracking.uri={uri}", "-m", "seed=0,1", cwd=tmp_path)
    assert message.startswith("tracking.uri: expected an MLflow store that can be written; ")
    assert said in message


def test_a_person_who_asks_for_a_traceback_gets_it(tmp_path: Path) -> None:
    ended = run_acoexp("nope=1", cwd=tmp_path, env={"HYDRA_FULL_ERROR": "1"})
    assert ended.returncode == 1
    assert "Traceback" in ended.stderr


def test_a_person_who_asks_for_the_traceback_of_a_job_gets_it_too(tmp_path: Path) -> None:
    ended = run_acoexp("algo=mmas", "rho=0", *QUICK, cwd=tmp_path, env={"HYDRA_FULL_ERROR": "1"})
    assert ended.returncode == 1
    assert "max_min.py" in ended.stderr
    assert ended.stderr.splitlines()[-1].startswith("acoexp.errors.SettingsError: rho: expected")


def checked(*overrides: str) -> str:
    """Compose a configuration as Hydra does, check it as every job is checked, and return the refusal."""
    register_options(None)
    with initialize_config_dir(str(conf_dir()), version_base="1.3"):
        config = compose("config", list(overrides))
    with pytest.raises((AcoexpError, OmegaConfBaseException)) as caught:
        Job(plain(config), Handover())
    message = in_one_line(caught.value)
    assert "\n" not in message
    return message


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("+nope=1", "nope is not a known key; expected one of: alpha"),
        ("+report.nope=1", "report.nope is not a known key"),
        ("+tracking.nope=1", "tracking.nope is not a known key; expected one of: tracking.uri"),
        ("+map.nope=1", "map.nope is not a known key; expected one of: map.moves"),
        ("+field.nope=1", "field.nope is not a known key; expected one of: field.attraction"),
        ("ants=0", "ants: expected a whole number from 1 to 100000; got 0"),
        ("ants=2.5", "ants: expected a whole number from 1 to 100000; got 2.5"),
        ("ants=true", "ants: expected a whole number from 1 to 100000; got True"),
        ("iterations=0", "iterations: expected a whole number"),
        ("rho=nan", "rho: expected a number from 0 to 1; got nan"),
        ("alpha=inf", "alpha: expected a number"),
        ("alpha=[1,2]", "alpha: expected a number"),
        ("alpha=null", "alpha: expected a number from 0 to 100; got nothing"),
        ("field.reach=x", "field.reach: expected a number"),
        ("field=3", "field: expected a mapping of parameters; got 3"),
        ("diffusion.gamma=-1", "diffusion.gamma: expected a number from 0 to 1; got -1"),
        ("map.moves=jump", "map.moves: expected one of: free, no_squeeze, no_cut, four; got 'jump'"),
        ("seed=null", "seed: expected a whole number from 0 to 2^64 - 1; got nothing"),
        ("seed=1.0", "seed: expected a whole number from 0 to 2^64 - 1; got 1.0"),
        (
            "seed=18446744073709551616",
            "seed: expected a whole number from 0 to 2^64 - 1; got 18446744073709551616",
        ),
        ("seed=${nope}", "seed: Interpolation key 'nope' not found; where '${' is meant as it stands, type "),
        ("tracking.name=nope", "tracking: expected one of: mlflow, none; got 'nope'"),
        ("tracking.uri=''", "tracking.uri: expected the address of an MLflow store that lasts; got ''"),
        ("report.name=nope", "report: expected one of: "),
        ("map=file", "map.path: expected a text; got nothing"),
        ("~map", "map: expected one of the options that --help lists; got None"),
    ],
)
def test_every_other_bad_setting_is_refused_by_the_same_check(given: str, said: str) -> None:
    assert checked(given).startswith(said)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (
            "rhoo=1",
            "rhoo is not a known key; --help lists the keys, --cfg job shows the settings; did you mean rho?",
        ),
        ("field.reech=1", "field.reech is not a known key; --help lists the keys, "),
        ("diffusion.at_goal=1", "diffusion.at_goal is not a known key"),
        ("update.elitists=1", "update.elitists is a key of update=elitist, not of update=dual_ant_cycle"),
        ("diffusion=gausian", "diffusion: expected one of: gaussian, luo_wu, none; got 'gausian'; did you mean "),
        (
            "map=gaussian",
            "map: expected one of: env1, env2, fig13, file, image, maze, movingai, random, rectangles, rooms, "
            "ros; "
            "got 'gaussian'; there is diffusion=",
        ),
    ],
)
def test_what_hydra_refuses_is_told_with_what_may_have_been_meant(given: str, said: str) -> None:
    register_options(None)
    with initialize_config_dir(str(conf_dir()), version_base="1.3"), pytest.raises(HydraException) as caught:
        compose("config", [given])
    assert in_one_line(caught.value).startswith(said)


MAPS: dict[bytes, str] = {
    b"": "an empty text",
    b"; moves: free\n\n": "an empty text",
    b"...\n..\n...\n": "row 2 has 2 cells; expected 3",
    b"...\n.x.\n...\n": "row 2, column 2: expected one of . # S G; got 'x'",
    b"0 1\n0 4\n": "row 2, column 2: expected one of 0 1",
    b"\x89PNG\xff\xfe\x00\x01": "UTF-8",
    b"#..\n...\n...\n": "start (0, 0) is an obstacle",
    b"...\n...\n..#\n": "goal (2, 2) is an obstacle",
    b".#.\n#..\n...\n": "no way leads from start (0, 0) to goal (2, 2) under the rule 'no_squeeze'",
    b"; moves: jump\n..\n..\n": "expected one of: free, no_squeeze, no_cut, four; got 'jump'",
}


@pytest.mark.parametrize("content", MAPS)
def test_a_bad_map_is_refused_by_its_files_name(content: bytes, tmp_path: Path) -> None:
    yard = tmp_path / "yard.txt"
    yard.write_bytes(content)
    message = checked("map=file", f"map.path={yard}")
    assert MAPS[content] in message
    assert "yard.txt" in message


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("map.goal=[9,9]", "goal (9, 9) lies outside; expected a cell from (0, 0) to (1, 1)"),
        ("map.start=[-1,0]", "start (-1, 0) lies outside"),
        ("map.start=[1]", "map.start: expected a pair [row, column]; got [1]"),
        ("map.start=[1,1]", "start and goal are one cell"),
        ("map.path=gone.txt", "map.path: expected a readable text file; got 'gone.txt'"),
        ("map.path=/", "map.path: expected a readable text file; got '/'"),
    ],
)
def test_a_bad_place_is_refused(given: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "yard.txt").write_text("..\n..\n", encoding="utf-8")
    assert said in checked("map=file", f"map.path={tmp_path / 'yard.txt'}", given)
