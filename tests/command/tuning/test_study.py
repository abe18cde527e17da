"""A study: what it is asked for and told, kept in a real database, gone on with by another command."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import pytest
import yaml
from hydra.core.override_parser.overrides_parser import OverridesParser

from acoexp.command.options.tuning import SAMPLERS, TuningKeys
from acoexp.command.tuning.space import Space
from acoexp.command.tuning.study import Study
from acoexp.errors import SettingsError, TrackingError

pytest.importorskip("optuna")

NUMBERS = ("rho=interval(0.1,0.9)", "beta=tag(log,interval(1e-3,1))", "ants=int(interval(1,8))", "algo=aco,pd")
COUNTABLE = ("ants=range(1,4)", "algo=aco,pd")


def opened(*overrides: str, sampler: str = "tpe", **keys: Any) -> Study:
    """Open a study; what its sampler or it is not told has its default."""
    space = Space(OverridesParser.create().parse_overrides(list(overrides)))
    of_sampler = {key: keys.pop(key) for key in ("seed", "population_size") if key in keys}
    return Study(TuningKeys(**keys), (sampler, SAMPLERS[sampler](**of_sampler)), space)


def run(study: Study, trials: int) -> list[dict[str, Any]]:
    """Run trials whose jobs return the sum of all numbers; return what was chosen."""
    chosen = []
    for _ in range(trials):
        trial = study.ask()
        study.tell(trial, sum(value for value in trial.values.values() if not isinstance(value, str)))
        chosen.append(trial.values)
    return chosen


def best(study: Study, folder: Path) -> dict[str, Any]:
    """Return what a study says was best."""
    study.write_best(folder / "best.yaml")
    found: dict[str, Any] = yaml.safe_load((folder / "best.yaml").read_text(encoding="utf-8"))
    return found


@pytest.fixture
def storage(tmp_path: Path) -> str:
    """The address of a database that is not there yet, in a folder that is not there either."""
    return f"sqlite:///{tmp_path}/a ?%41b/study.db"


@pytest.mark.parametrize("sampler", ["tpe", "random", "cmaes", "nsgaii"])
def test_each_sampler_repeats_itself_by_its_seed_and_warns_of_nothing(sampler: str, storage: str) -> None:
    keys = {"population_size": 4} if sampler == "nsgaii" else {}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        first = run(opened(*NUMBERS, sampler=sampler, seed=1, **keys), 20)
        kept = run(opened(*NUMBERS, sampler=sampler, seed=1, storage=storage, **keys), 20)
        other = run(opened(*NUMBERS, sampler=sampler, seed=2, **keys), 20)
    assert first == kept != other
    for chosen in first:
        assert 0.1 <= chosen["rho"] <= 0.9
        assert 1e-3 <= chosen["beta"] <= 1
        assert chosen["ants"] in range(1, 9)
        assert chosen["algo"] in ("aco", "pd")


@pytest.mark.parametrize("direction", ["minimize", "maximize"])
@pytest.mark.parametrize("sampler", ["tpe", "random", "cmaes", "nsgaii"])
def test_a_job_whose_ants_never_arrived_is_the_worst_whatever_the_direction(
    sampler: str, direction: str, storage: str, tmp_path: Path
) -> None:
    study = opened(*NUMBERS, sampler=sampler, seed=1, direction=direction, storage=storage)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for number in range(30):
            study.tell(study.ask(), 5.0 if number == 3 else math.inf)
    assert best(study, tmp_path)["best_value"] == 5.0


def test_the_best_is_what_a_job_returned_and_what_it_was_told(tmp_path: Path) -> None:
    study = opened(*NUMBERS, seed=1, study_name="mine")
    study.write_best(tmp_path / "best.yaml")
    assert not (tmp_path / "best.yaml").exists()
    study.tell(study.ask(), None)  # failed
    chosen = run(study, 8)
    lowest = min(chosen, key=lambda values: values["rho"] + values["beta"] + values["ants"])
    found = best(study, tmp_path)
    assert (found["name"], found["study_name"], found["best_params"]) == ("optuna", "mine", lowest)
    assert found["best_value"] == pytest.approx(lowest["rho"] + lowest["beta"] + lowest["ants"])


@pytest.mark.parametrize("sampler", ["tpe", "random"])
def test_a_second_command_goes_on_with_other_values_also_by_the_same_seed(sampler: str, storage: str) -> None:
    keys: dict[str, Any] = {"sampler": sampler, "seed": 1, "storage": storage, "study_name": "s"}
    first, second = opened(*NUMBERS, **keys), None
    before = run(first, 4)
    second = opened(*NUMBERS, **keys)
    assert (first.trials_before, second.trials_before, second.name) == (0, 4, "s")
    after = run(second, 4)
    assert not [values for values in after if values in before]


def test_a_study_is_not_gone_on_with_in_another_direction_or_by_another_kind_of_value(storage: str) -> None:
    run(opened(*NUMBERS, storage=storage, study_name="s"), 1)
    with pytest.raises(
        SettingsError, match=r"^hydra\.sweeper\.direction: expected minimize, as study 's' was begun"
    ):
        opened(*NUMBERS, storage=storage, study_name="s", direction="maximize")
    for other in ("rho=0.1,0.9", "rho=tag(log,interval(0.1,0.9))"):
        with pytest.raises(
            SettingsError, match=r"^rho: expected FloatDistribution.*, as study 's' was begun with; got "
        ):
            opened(other, storage=storage, study_name="s")
    run(
        opened("rho=interval(0.4,0.6)", storage=storage, study_name="s"), 1
    )  # a narrower interval is no other kind


def test_a_grid_tries_every_combination_once_also_in_two_commands(storage: str) -> None:
    keys: dict[str, Any] = {"sampler": "grid", "storage": storage, "study_name": "s"}
    study = opened(*COUNTABLE, **keys)
    assert study.left(20) == 6
    before = run(study, 2)
    study.ask()  # whose command was killed
    study = opened(*COUNTABLE, **keys)
    assert study.left(20) == 4
    after = run(study, 4)
    assert study.left(20) == 0
    every = [{"ants": ants, "algo": algo} for ants in (1, 2, 3) for algo in ("aco", "pd")]
    assert before + after == [*every[:2], *every[3:], every[2]]


def test_a_grid_leaves_what_failed_to_the_next_command() -> None:
    study = opened(*COUNTABLE, sampler="grid")
    first = study.ask()
    study.tell(first, None)
    assert first.values not in run(study, 5)
    assert run(study, 1) == [first.values]


def test_numbers_are_needed_by_a_sampler_that_goes_by_them() -> None:
    with pytest.raises(SettingsError, match=r"cmaes expects intervals or ranges for at least two keys; got rho$"):
        opened("rho=interval(0,1)", "algo=aco,pd", sampler="cmaes")


@pytest.mark.parametrize(
    ("address", "said"),
    [
        ("study.db", "Could not parse"),
        ("http://example.org", "Can't load plugin"),
        ("sqlite:////dev/null/study.db", "/dev/null"),
        ("postgresql://me:s3cret@127.0.0.1:1/x", ""),
    ],
)
def test_what_is_no_database_is_told_without_its_password(address: str, said: str) -> None:
    with pytest.raises(
        TrackingError, match=r"^hydra\.sweeper\.storage: expected a database for a study; got"
    ) as caught:
        opened(*NUMBERS, storage=address)
    assert said in str(caught.value)
    assert "s3cret" not in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_database_that_is_none(tmp_path: Path) -> None:
    (tmp_path / "study.db").write_text(
        "this is a letter to my aunt, of some length, so that it has a header\n" * 9
    )
    with pytest.raises(TrackingError, match=r"file is not a database$"):
        opened(*NUMBERS, storage=f"sqlite:///{tmp_path}/study.db")


def test_a_database_that_would_be_forgotten_is_refused() -> None:
    with pytest.raises(
        SettingsError, match=r"^hydra\.sweeper\.storage: expected the address of a database that lasts"
    ):
        opened(*NUMBERS, storage="sqlite://")


def test_a_database_that_is_spoilt_meanwhile_is_told(tmp_path: Path) -> None:
    study = opened(*NUMBERS, storage=f"sqlite:///{tmp_path}/study.db")
    run(study, 1)
    (tmp_path / "study.db").write_bytes(b"spoilt" * 5000)
    with pytest.raises(TrackingError, match=r"^hydra\.sweeper\.storage: expected a database for a study"):
        run(study, 1)
