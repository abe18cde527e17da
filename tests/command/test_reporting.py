"""The report that a command asks for, and the folder that it goes to."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig, read_write
from running import QUICK, install, listing, refusal, run_acoexp

from acoexp import SettingsError
from acoexp.command.reporting import asked_report
from acoexp.parameters import parameter
from acoexp.report.report import Report

Composed = Callable[..., DictConfig]
COMPARE = ("report=compare", "report.cells=[aco,pd]", "report.trials=2", *QUICK)


@dataclass(frozen=True, kw_only=True)
class Own(Report):
    """A report with a key of its own that is called like ours."""

    folder: str = parameter("drawer", "what it means by that")

    def write(self, context: object) -> Path:
        raise NotImplementedError


def test_a_report_is_asked_for_with_its_keys(composed: Composed) -> None:
    asked = asked_report({"name": "compare", "folder": "mine", "trials": 7})
    assert asked is not None
    assert (asked.report.trials, asked.folder) == (7, Path("mine"))
    assert asked.given == {"name": "compare", "trials": 7}  # it says the same wherever it lies
    assert asked_report({"name": "none"}) is None


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"name": "none", "trials": 1}, "report.trials is not a known key of report=none"),
        ({"name": "compare", "folder": 7}, "report.folder: expected a text; got 7"),
        (
            {"name": "compare", "folder": "~nobody_here/x"},
            "report.folder: expected a folder; got '~nobody_here/x': ",
        ),
        ({"name": "compare", "folder": ""}, "report.folder: expected a new or an empty folder"),
        ({"name": "compare", "folders": "x"}, "report.folders is not a known key"),
    ],
)
def test_what_cannot_be_asked_for_is_refused(given: dict[str, object], said: str, composed: Composed) -> None:
    with pytest.raises(SettingsError) as caught:
        asked_report(given)
    assert str(caught.value).startswith(said)


def test_home_is_known_by_its_short_name(
    composed: Composed, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path / "me"))
    asked = asked_report({"name": "compare", "folder": "~/mine"})
    assert asked is not None
    assert asked.folder == tmp_path / "me" / "mine"


def test_a_key_of_a_reports_own_that_is_called_the_same_means_what_it_means_there(
    composed: Composed, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("acoexp.command.reporting.find_part", lambda group, name: Own)
    monkeypatch.setattr("acoexp.command.reporting.build_part", lambda group, name, given: Own(**given))
    asked = asked_report({"name": "own", "folder": "."})
    assert asked is not None
    assert (asked.folder, asked.report) == (None, Own(folder="."))


@pytest.mark.parametrize(
    ("mode", "run_dir", "named", "folder"),
    [
        (RunMode.RUN, "outputs/runs/2024-05-01/12-30-15-0123abcd", None, "outputs/reports/compare"),
        (RunMode.RUN, "mine", None, "mine/compare"),
        (RunMode.RUN, "outputs/runs/mine", None, "outputs/runs/mine/compare"),
        (RunMode.RUN, "mine", "yours", "yours"),
        (RunMode.MULTIRUN, "outputs/runs/2024-05-01/12-30-15-0123abcd", None, "job/compare"),
        (RunMode.MULTIRUN, "mine", None, "job/compare"),
        (RunMode.MULTIRUN, "mine", "yours", "yours"),
    ],
)
def test_it_goes_where_one_says_or_into_the_jobs_folder_or_among_reports(
    mode: RunMode, run_dir: str, named: str | None, folder: str, composed: Composed
) -> None:
    config = composed(mode=mode)
    with read_write(config.hydra):
        config.hydra.run.dir = run_dir
    HydraConfig.instance().set_config(config)
    asked = asked_report({"name": "compare", "folder": named})
    assert asked is not None
    assert asked.place(Path("job")) == Path(folder)


# --- as a person runs it


def test_it_is_written_where_one_says_and_another_commands_is_kept(tmp_path: Path) -> None:
    for rho in ("0.1", "0.1", "0.2"):
        ended = run_acoexp(*COMPARE, f"rho={rho}", "report.folder=all/mine", cwd=tmp_path)
        assert ended.returncode == 0, ended.stderr
        assert ended.stdout.endswith("report: all/mine\n")
    names = sorted(path.name for path in (tmp_path / "all").iterdir())
    assert len(names) == 2
    assert names[1].startswith("mine-")
    assert f"is kept: all/{names[1]}" in ended.stderr
    told = [json.loads((tmp_path / "all" / name / "report.json").read_text("utf-8")) for name in names]
    assert [one["configurations"]["aco"]["rho"] for one in told] == [0.2, 0.1]
    assert not (tmp_path / "outputs/reports").exists()


def test_in_the_runs_folder_it_lies_by_its_name(tmp_path: Path) -> None:
    ended = run_acoexp(*COMPARE, "hydra.run.dir=here", cwd=tmp_path)
    assert ended.stdout.endswith("report: here/compare\n")
    assert (tmp_path / "here/compare/index.html").is_file()
    assert not (tmp_path / "outputs").exists()


def test_a_folder_of_other_things_is_refused_before_anything_runs(tmp_path: Path) -> None:
    (tmp_path / "thesis").mkdir()
    (tmp_path / "thesis" / "chapter").touch()
    for folder, why in (("thesis", "other files are in it"), (".", "the command itself runs in it")):
        said = refusal(*COMPARE, f"report.folder={folder}", cwd=tmp_path)
        assert said.startswith(
            f"report.folder: expected a new or an empty folder, or one with a report; got '{folder}': {why}"
        )


def test_the_folder_of_the_store_or_of_the_run_is_never_moved(tmp_path: Path) -> None:
    """They are made after the first look at it; so there is a second one."""
    tracked = [text for text in COMPARE if text != "tracking=none"]
    for given in (("tracking.uri=sqlite:///mine/x.db", *tracked), ("hydra.run.dir=mine", *COMPARE)):
        ended = run_acoexp(*given, "report.folder=mine", cwd=tmp_path)
        assert ended.returncode == 1
        assert ended.stderr.splitlines()[-1].startswith(
            "acoexp: error: report.folder: expected a new or an empty folder"
        )
    assert (tmp_path / "mine/x.db").is_file()


def test_jobs_of_a_sweep_have_a_folder_each(tmp_path: Path) -> None:
    said = refusal(*COMPARE, "-m", "rho=0.1,0.2", "report.folder=mine", cwd=tmp_path)
    assert said.startswith("report.folder: expected one for each job of a sweep, such as ")
    assert said.endswith("; got 'mine' for several")
    ended = run_acoexp(*COMPARE, "-m", "rho=0.1,0.2", 'report.folder="mine/${rho}"', cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert {path.parent.name for path in tmp_path.glob("mine/*/index.html")} == {"0.1", "0.2"}


def test_a_strangers_report_that_knows_nothing_of_it_loses_nothing(tmp_path: Path) -> None:
    env = install(
        tmp_path / "site",
        "noted",
        "[acoexp.report]\nnoted = noted:Noted\n",
        {"noted.py": NOTED},
    )
    (tmp_path / "home").mkdir()
    home = tmp_path / "home"
    for rho in ("0.1", "0.1", "0.2"):
        ended = run_acoexp("report=noted", *QUICK, f"rho={rho}", "report.folder=mine", cwd=home, env=env)
        assert ended.returncode == 0, ended.stderr
    kept = next(path for path in home.iterdir() if path.name.startswith("mine-"))
    assert [(folder / "note").read_text("utf-8") for folder in (home / "mine", kept)] == ["0.2", "0.1"]
    assert listing(home / "mine") == {"note", ".made-by.json"}


NOTED = '''
from dataclasses import dataclass
from acoexp.report.report import Report

@dataclass(frozen=True, kw_only=True)
class Noted(Report):
    """A note."""

    def write(self, context):
        context.folder.mkdir(parents=True, exist_ok=True)
        (context.folder / "note").write_text(str(context.settings.scalars.rho))
        return context.folder
'''
