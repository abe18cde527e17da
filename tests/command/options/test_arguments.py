"""Arguments: what a person may write, and what Hydra gets of it."""

from __future__ import annotations

import argparse

import pytest
from hydra._internal.utils import get_args_parser
from hypothesis import given, settings
from hypothesis import strategies as st

from acoexp.command.options.arguments import normalise
from acoexp.errors import SettingsError


def hydra_sees(*argv: str) -> argparse.Namespace:
    """Return what Hydra's own parser makes of the arguments after us."""
    return get_args_parser().parse_args(normalise(list(argv)).argv)


def overrides(*argv: str) -> list[str]:
    """Return the overrides that Hydra gets, without the folders that we add."""
    return [override for override in hydra_sees(*argv).overrides if ".dir=" not in override]


def folders(*argv: str) -> list[str]:
    """Return the folders that Hydra is told to use."""
    return [override for override in hydra_sees(*argv).overrides if ".dir=" in override]


def test_overrides_may_stand_on_both_sides_of_a_flag() -> None:
    seen = hydra_sees("algo=pdg", "map=env2", "-m", "seed=0,1")
    assert seen.multirun
    assert seen.overrides[:3] == ["algo=pdg", "map=env2", "seed=0,1"]


FLAGS = ([], ["-m"], ["--cfg=job", "--resolve"], ["--config-dir=x", "--multirun"])


@settings(max_examples=50)
@given(st.data())
def test_no_order_of_flags_and_overrides_loses_any(data: st.DataObject) -> None:
    given_overrides = data.draw(st.lists(st.sampled_from(["algo=pd", "seed=3", "+a=1", "~b", "map.path=-m"])))
    argv = list(given_overrides)
    for flag in data.draw(st.sampled_from(FLAGS)):
        argv.insert(data.draw(st.integers(0, len(argv))), flag)
    assert overrides(*argv) == given_overrides


@pytest.mark.parametrize(
    ("written", "numbers"),
    [
        ("seed=0-9", "seed=0,1,2,3,4,5,6,7,8,9"),
        ("seed=0-4,7", "seed=0,1,2,3,4,7"),
        ("seed=7,0-2,9-10", "seed=7,0,1,2,9,10"),
        ("seed=3-3", "seed=3"),
        ("ants=1-3", "ants=1,2,3"),
        ("iterations=98-101", "iterations=98,99,100,101"),
        ("map.seed=0-3", "map.seed=0,1,2,3"),
        ("map.instance=7,0-2", "map.instance=7,0,1,2"),
        ("threads=1-2", "threads=1,2"),
    ],
)
def test_a_range_stands_for_all_its_whole_numbers(written: str, numbers: str) -> None:
    assert overrides(written, "-m") == [numbers]


@pytest.mark.parametrize(
    "written",
    [
        "seed=4",
        "seed=4,2",
        "seed=-1",
        "seed=a-b",
        "seed=range(0,3)",
        "map.path=1-3",
        "map.path=a-b",
        "map.density=0-1",
        "map.nothing=0-1",
        "report.seeds=0-1",
        "rho=0-1",
        "map.start=[1,2]",
    ],
)
def test_what_is_no_range_of_whole_numbers_stays_as_it_is(written: str) -> None:
    assert overrides(written, "-m") == [written]


def test_a_range_must_not_run_backwards() -> None:
    with pytest.raises(SettingsError, match=r"seed: expected a range from low to high.*'9-0'"):
        normalise(["seed=1,9-0", "-m"])
    with pytest.raises(SettingsError, match=r"map\.seed: expected a range from low to high.*'9-0'"):
        normalise(["map.seed=1,9-0", "-m"])


@pytest.mark.parametrize(
    "several", ["seed=0-9", "map.seed=0-9", "seed=0,1", "algo=aco,pd", "rho=choice(0.1,0.2)", "seed=range(0,9)"]
)
def test_a_forgotten_m_is_told(several: str) -> None:
    with pytest.raises(SettingsError) as caught:
        normalise(["map=env2", several])
    assert str(caught.value).startswith(f"{several}: several values; add -m")


@pytest.mark.parametrize("one", ["map.start=[1,2]", "map.path='a,b'", "rho=0.5", "~seed", "+x={a:1,b:2}"])
def test_one_value_needs_no_m(one: str) -> None:
    assert overrides(one) == [one]


def test_several_values_need_no_m_where_hydra_is_told_otherwise() -> None:
    assert overrides("hydra.mode=MULTIRUN", "seed=0-1") == ["hydra.mode=MULTIRUN", "seed=0,1"]


@pytest.mark.parametrize(
    ("argv", "said"),
    [
        (["hydra.mode=foo"], "hydra.mode: expected RUN or MULTIRUN; got 'foo'"),
        (["hydra.mode=RUN", "-m"], "expected only one of --multirun and hydra.mode=RUN"),
        (["algo=1"], "algo: expected one of the options that --help lists; got 1"),
        (["heuristic=nan"], "heuristic: expected one of the options that --help lists; got nan"),
        (["engine=true"], "engine: expected one of the options that --help lists; got True"),
        (["-m", "map=env2,1.5"], "map: expected one of the options that --help lists; got 1.5"),
    ],
)
def test_what_hydra_has_no_words_for_is_refused(argv: list[str], said: str) -> None:
    with pytest.raises(SettingsError) as caught:
        normalise(argv)
    assert str(caught.value) == said


@pytest.mark.parametrize("flag", ["--config-path", "--config-name", "-cp", "-cn", "--config-n"])
def test_the_programs_own_configuration_cannot_be_replaced(flag: str) -> None:
    with pytest.raises(SettingsError, match=r"--config-(path|name): expected overrides.*--config-dir.*'x'"):
        normalise(["seed=1", flag, "x"])


@pytest.mark.parametrize("flag", [["--info"], ["-i"], ["--cfg", "job"], ["-c", "job"], ["--help"], ["-h"]])
@pytest.mark.parametrize("before", [True, False])
def test_a_flag_takes_no_override_for_its_value(flag: list[str], before: bool) -> None:
    override = ["map=env2"]
    assert overrides(*(flag + override if before else override + flag)) == override


@pytest.mark.parametrize(
    ("argv", "seen"),
    [
        (
            ["diffusion=none,gaussian", "diffusion.gamma=0.1"],
            ["diffusion=none,gaussian", "diffusion.gamma=choice(0.1)"],
        ),
        (["post.x=a b", "algo=pd,pdg"], ["post.x=choice(a b)", "algo=pd,pdg"]),
        (["diffusion=none,gaussian", "diffusion.gamma=1,2"], ["diffusion=none,gaussian", "diffusion.gamma=1,2"]),
        (["diffusion=gaussian", "diffusion.gamma=1", "rho=0.1,0.2"], None),
        (["algo=pd,pdg", "map.path=x", "field.reach=3", "+diffusion.gamma=1", "tracking.uri=x"], None),
    ],
)
def test_a_parameter_of_a_part_that_is_swept_waits_for_each_job(argv: list[str], seen: list[str] | None) -> None:
    assert overrides(*argv, "-m") == (argv if seen is None else seen)


def test_a_flags_own_value_stays_with_it() -> None:
    seen = hydra_sees("--info", "defaults", "seed=1", "--package", "map")
    assert (seen.info, seen.package, seen.overrides) == ("defaults", "map", ["seed=1"])


@pytest.mark.parametrize(
    "written",
    [["--config-dir", "mine"], ["--config-dir=mine"], ["-cd", "mine"], ["-cd=mine"], ["--config-d", "mine"]],
)
def test_the_users_folder_reaches_hydra_through_us_alone(written: list[str]) -> None:
    argv = ["algo=pd", *written, "-m", "seed=1"]
    assert normalise(argv).config_dir == "mine"
    assert hydra_sees(*argv).config_dir is None
    assert overrides(*argv) == ["algo=pd", "seed=1"]


@pytest.mark.parametrize("written", ["--nope", "-cd", "--config-"])
def test_what_is_no_flag_is_refused(written: str) -> None:
    with pytest.raises(SettingsError, match=written):
        normalise([written])


def test_without_a_folder_there_is_none() -> None:
    assert normalise(["seed=1"]).config_dir is None


def test_every_run_and_sweep_has_a_folder_of_its_own() -> None:
    seen = [folders("seed=1") for _ in range(100)]
    assert len({text for run in seen for text in run}) == 200
    assert all(
        run.startswith("hydra.run.dir=outputs/runs/") and sweep.startswith("hydra.sweep.dir=outputs/sweeps/")
        for run, sweep in seen
    )


def test_the_users_own_folder_is_kept() -> None:
    run, sweep = sorted(folders("hydra.run.dir=here", "seed=1"))
    assert run == "hydra.run.dir=here"
    assert sweep.startswith("hydra.sweep.dir=outputs/sweeps/")


@pytest.mark.parametrize("flag", [["--cfg", "job"], ["--info"], ["--help"]])
def test_what_runs_nothing_needs_no_folder(flag: list[str]) -> None:
    assert folders(*flag) == []


def test_an_override_that_cannot_be_read_is_refused() -> None:
    with pytest.raises(SettingsError, match="seed"):
        normalise(["seed"])


@pytest.mark.parametrize(
    ("written", "one_text"),
    [("seeds=0-9", "seeds='0-9'"), ("seeds=20,0-9", "seeds='0-9,20'"), ("seeds='3,4'", "seeds='3-4'")],
)
@pytest.mark.parametrize("flags", [[], ["-m"]])
def test_the_seeds_of_a_batch_are_never_several_jobs(written: str, one_text: str, flags: list[str]) -> None:
    assert overrides(written, *flags)[0] == one_text


@pytest.mark.parametrize(
    "written", ["seeds=range(0,9)", "seeds=-3", "seeds=9-0", "seeds=1,1", "seeds=", "seeds=[1]"]
)
def test_seeds_that_are_none_are_refused(written: str) -> None:
    with pytest.raises(SettingsError, match=r"^seeds: expected"):
        normalise([written, "-m"])


def test_a_seed_and_seeds_together_are_refused() -> None:
    with pytest.raises(SettingsError, match=r"expected seed .* or seeds .*; got seed=3 and seeds='0-9'"):
        normalise(["seed=3", "seeds=0-9"])


NUMBERS = ",".join(str(number / 1000) for number in range(1, 1001))


@pytest.mark.parametrize(
    ("sweep", "said"),
    [
        (["seed=0-100000"], "seed: expected at most 100000 values, each a job; got '0-100000'"),
        (
            ["seed=0-60000,70000-130000"],
            "seed: expected at most 100000 values, each a job; got '0-60000,70000-130000'",
        ),
        (["seed=range(0,100001)"], "seed=range(0,100001): expected at most 100000 values, each a job"),
        (["rho=range(0,1,step=0)"], "rho=range(0,1,step=0): expected at most 100000 values, each a job"),
        (["seed=0-1000", "ants=1-1000"], "expected a sweep of at most 1000000 jobs; got 1001000; "),
        (["seed=0-1000", f"rho=choice({NUMBERS})"], "expected a sweep of at most 1000000 jobs; got 1001000; "),
        (["seed=0-1000", f"rho={NUMBERS}"], "expected a sweep of at most 1000000 jobs; got 1001000; "),
    ],
)
def test_a_sweep_that_would_never_end_is_refused(sweep: list[str], said: str) -> None:
    with pytest.raises(SettingsError) as caught:
        normalise([*sweep, "-m"])
    assert str(caught.value).startswith(said)


def test_an_optimiser_chooses_from_as_much_as_it_likes() -> None:
    sweep = ["hydra/sweeper=optuna", "seed=range(0,1000000)", "rho=interval(0,1)"]
    assert overrides(*sweep, "-m") == sweep
