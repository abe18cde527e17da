"""A job: what a configuration asks for, checked before anything is written, then run."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml
from hydra.types import RunMode
from omegaconf import DictConfig
from running import listing

from acoexp import Grid, solve, solve_many
from acoexp.command.handover import Handover
from acoexp.command.job import Job, plain
from acoexp.errors import SettingsError, StrategyError, TrackingError
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context
from acoexp.report.report import Report
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.solver import Solver

Composed = Callable[..., DictConfig]

QUICK = ("algo=aco", "tracking=none", "iterations=3", "ants=2")
FEW: dict[str, Any] = {"iterations": 3, "ants": 2}
TRAP = Grid(
    [[0, 0, 0, 0, 0], [0, 1, 1, 1, 0], [0, 0, 0, 1, 0], [0, 1, 1, 1, 0], [0, 0, 0, 0, 0]],
    start=(2, 0),
    goal=(2, 4),
    moves="no_cut",
)
"""An ant that follows its nose walks into the dead end, and cannot turn back."""


@pytest.fixture
def made(composed: Composed, handover: Handover) -> Callable[..., Job]:
    """Return what makes a job from overrides."""
    return lambda *overrides, **options: Job(plain(composed(*overrides, **options)), handover)


# --- what it is


def test_it_is_what_the_configuration_says(made: Callable[..., Job]) -> None:
    job = made("algo=pd", "map=env2", "map.moves=free", "rho=0.25", "field.reach=3", "seed=7", "tracking=none")
    assert job.setup.settings == resolve("pd", {"rho": 0.25, "field": {"reach": 3.0}})
    assert (job.setup.grid.name, job.setup.grid.moves) == ("env2", "free")
    assert (job.keys.seed, job.seeds, job.trials, job.keys.resume) == (7, None, 1, True)
    assert (job.tracker.address, job.report) == (None, None)


def test_seeds_are_many_trials(made: Callable[..., Job]) -> None:
    job = made(*QUICK, "seeds='20,0-9'", "threads=2", "resume=false")
    assert (job.seeds, job.trials) == (parse_seeds("0-9,20"), 11)
    assert (job.keys.seeds, job.keys.threads, job.keys.resume) == ("0-9,20", 2, False)


def test_what_is_kept_of_it_depends_on_nothing_but_its_settings_and_its_map(made: Callable[..., Job]) -> None:
    one = made("algo=pd", "rho=1", "seed=3", "tracking.uri='http://user:secret@server'")
    other = made("algo=pd", "rho=1.0", "seeds='0-9'", "threads=3", "resume=false", "tracking=none")
    assert one.setup.params == other.setup.params
    assert "secret" not in str(one.setup.params)
    assert (one.setup.params["rho"], one.setup.params["map.name"]) == ("1.0", "fig13")


def test_a_worker_uses_the_map_and_the_address_that_its_parent_hands_over(
    made: Callable[..., Job], handover: Handover, tmp_path: Path
) -> None:
    grid = Grid([[0, 0]], name="another")
    job = made("tracking.uri=sqlite:///x.db")
    handover.put_maps(tmp_path, [(job.config["map"], grid)])
    handover.addresses["sqlite:///x.db"] = "sqlite:////elsewhere/x.db"
    job = made("tracking.uri=sqlite:///x.db")
    assert job.setup.grid.digest == grid.digest
    assert job.tracker.address == "sqlite:////elsewhere/x.db"


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        (["report=compare", "seeds='0-9'"], "seeds: expected none with a report, which has keys of its own"),
        (["report=compare", "report.cells=[aco]"], "report.cells: expected two or more, each different"),
        (["+report.nope=1"], "report.nope is not a known key of report=none"),
        (["~map"], "map: expected one of the options that --help lists; got None"),
    ],
)
def test_what_is_wrong_is_told_before_anything_is_written(
    made: Callable[..., Job], overrides: list[str], said: str, tmp_path: Path
) -> None:
    with pytest.raises(SettingsError) as caught:
        made(*overrides)
    assert str(caught.value).startswith(said)
    assert listing(tmp_path) == {"job"}


# --- how it runs


def test_a_trial_leaves_its_settings_its_record_and_its_pictures_and_returns_its_length(
    made: Callable[..., Job], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    job = made(*QUICK, "seed=3")
    result = solve("fig13", "aco", 3, **FEW)
    assert job.run() == (result.length if result.path is not None else math.inf)
    written = {"config.yaml", "trial.json", "path.csv", "path.png", "convergence.png"}
    assert listing(tmp_path / "job") == (written if result.path is not None else written - {"path.csv"})
    assert (
        json.loads((tmp_path / "job" / "trial.json").read_text("utf-8"))["lost_ants"] == result.lost_ants.tolist()
    )
    assert yaml.safe_load((tmp_path / "job" / "config.yaml").read_text("utf-8")) == job.config
    assert "files: job" in capsys.readouterr().out


def test_a_database_that_cannot_be_written_is_refused_before_the_trial_and_another_store_after_it(
    made: Callable[..., Job], tmp_path: Path
) -> None:
    (tmp_path / "x.db").write_text("no database of SQLite's\n" * 100)
    with pytest.raises(TrackingError, match="not a database"):
        made(*QUICK, "tracking=mlflow", "tracking.uri=sqlite:///x.db").prepare()
    elsewhere = ("tracking=mlflow", "tracking.uri='nope://there'")
    made(*QUICK, *elsewhere).prepare()
    for many in (("seeds='0-1'",), ("report=compare", "report.cells=[aco,pd]")):
        with pytest.raises(TrackingError, match="nope"):
            made(*QUICK, *elsewhere, *many).prepare()


def test_a_trial_of_a_sweep_draws_and_prints_nothing(
    made: Callable[..., Job], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    made(*QUICK, mode=RunMode.MULTIRUN).run()
    assert listing(tmp_path / "job") == {"config.yaml", "trial.json"}
    assert capsys.readouterr() == ("", "")


def test_a_picture_that_cannot_be_drawn_is_no_more_than_a_warning(
    made: Callable[..., Job], monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, tmp_path: Path
) -> None:
    def fail(*_: Any) -> None:
        raise ValueError("no fonts")

    monkeypatch.setattr("acoexp.command.results.pictures.draw_map", fail)
    made(*QUICK).run()
    assert caplog.messages == ["the pictures could not be drawn: ValueError: no fonts"]
    assert "trial.json" in listing(tmp_path / "job")


def test_a_batch_leaves_a_record_and_a_table_and_returns_the_mean_length(
    made: Callable[..., Job], tmp_path: Path
) -> None:
    lengths = [result.length for result in solve_many("fig13", "pdg", range(4), iterations=20)]
    job = made("algo=pdg", "tracking=none", "iterations=20", "seeds='0-3'", mode=RunMode.MULTIRUN)
    assert job.run() == pytest.approx(sum(lengths) / 4)
    assert listing(tmp_path / "job") == {
        *("config.yaml", "batch.json", "trials.csv", "progress"),
        *("path.png", "convergence.png"),  # of the best trial
    }
    assert len((tmp_path / "job" / "trials.csv").read_text("utf-8").splitlines()) == 5
    assert (tmp_path / "job" / "progress").read_text("utf-8") == "4"


@pytest.mark.parametrize("seeds", ["seed=0", "seeds='0-2'"])
def test_where_no_ant_ever_arrived_an_optimiser_is_told_the_worst(
    made: Callable[..., Job], handover: Handover, seeds: str, tmp_path: Path
) -> None:
    overrides = (*QUICK, "beta=100", "field.repulsion=0", seeds)
    handover.put_maps(tmp_path, [(made(*overrides).config["map"], TRAP)])
    assert made(*overrides, mode=RunMode.MULTIRUN).run() == math.inf


def test_a_batch_with_trials_that_failed_keeps_the_others_and_says_how_many(
    made: Callable[..., Job], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def trial(self: Solver, workspace: Any, seed: int, run: Any = Solver._trial) -> Any:
        if seed % 2:
            raise StrategyError("the part broke")
        return run(self, workspace, seed)

    monkeypatch.setattr(Solver, "_trial", trial)
    with pytest.raises(StrategyError, match=r"^2 of 5 trials failed: the part broke$"):
        made(*QUICK, "seeds='0-4'", mode=RunMode.MULTIRUN).run()
    record = json.loads((tmp_path / "job" / "batch.json").read_text("utf-8"))
    assert (record["trials"], record["failed"]) == (3, 2)
    assert (tmp_path / "job" / "failed.txt").read_text("utf-8") == "2 of 5 trials failed: the part broke\n"


class Note(Report):
    """A report that says what it was given."""

    def write(self, context: Context) -> Path:
        context.folder.mkdir(parents=True)
        trials = context.run(context.settings, context.grid, parse_seeds("0-2"))
        said = f"{context.algo} {context.own_settings} {len(trials)}"
        (context.folder / "note").write_text(said, encoding="utf-8")
        return context.folder


@pytest.mark.parametrize(("mode", "folder"), [(RunMode.RUN, "job/compare"), (RunMode.MULTIRUN, "job/compare")])
def test_a_report_works_on_what_the_command_line_says_and_is_no_number(
    made: Callable[..., Job],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    mode: RunMode,
    folder: str,
    tmp_path: Path,
) -> None:
    monkeypatch.setattr("acoexp.command.reporting.build_part", lambda group, name, parameters: Note())
    assert math.isnan(made("report=compare", *QUICK, mode=mode).run())
    assert (tmp_path / folder / "note").read_text("utf-8") == "aco {'ants': 2, 'iterations': 3} 3"
    out, _ = capsys.readouterr()
    assert out.startswith("report: ")
    assert out.endswith(f"{folder}\n")
