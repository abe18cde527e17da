"""The example package as a stranger would have it: wheels in a virtual environment, run from another folder."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import venv
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import pytest
from mlflow import MlflowClient
from running import environment, trials
from running import install as install_package

pytestmark = pytest.mark.slow_without_jit

ROOT = Path(__file__).parent.parent.parent
EXAMPLE = ROOT / "plugins" / "acoexp-shy"
QUICK = ("iterations=5", "ants=3", "tracking=none")


class Installed(NamedTuple):
    """A virtual environment."""

    python: Path

    def run(self, *args: str, cwd: Path, env: Mapping[str, str] | None = None) -> subprocess.CompletedProcess[str]:
        """Run its Python."""
        return subprocess.run(
            [str(self.python), *args], cwd=cwd, env=environment(env), capture_output=True, text=True, timeout=300
        )

    def acoexp(self, *args: str, cwd: Path) -> str:
        """Run the command, which must succeed; return what it printed."""
        ended = self.run("-m", "acoexp", *args, cwd=cwd)
        assert ended.returncode == 0, ended.stderr
        return ended.stdout

    def refusal(self, *args: str, cwd: Path) -> str:
        """Run the command, which must fail with one line; return that."""
        ended = self.run("-m", "acoexp", *args, cwd=cwd)
        assert ended.returncode == 1
        assert ended.stderr.count("\n") == 1, ended.stderr
        return ended.stderr

    @property
    def packages(self) -> Path:
        """Where its packages lie."""
        version = f"python{sys.version_info.major}.{sys.version_info.minor}"
        return self.python.parent.parent / "lib" / version / "site-packages"


@pytest.fixture(scope="module")
def wheels(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """The wheels of acoexp and of the example."""
    folder = tmp_path_factory.mktemp("wheels")
    sources = [str(ROOT), str(EXAMPLE)]
    pip("wheel", "--no-deps", "--wheel-dir", str(folder), *sources)
    found = sorted(map(str, folder.glob("*.whl")))
    assert len(found) == len(sources)
    return found


def pip(*args: str) -> None:
    done = subprocess.run([sys.executable, "-m", "pip", "--quiet", *args], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def install(folder: Path, wheels: list[str]) -> Installed:
    """Make an environment with these wheels, which borrows their dependencies from the one we run in."""
    venv.create(folder, symlinks=True)
    installed = Installed(folder / "bin" / "python")
    pip("--python", str(installed.python), "install", "--no-deps", "--no-index", *wheels)
    borrowed = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib")}
    (installed.packages / "borrowed.pth").write_text("\n".join(sorted(borrowed)), encoding="utf-8")
    return installed


@pytest.fixture(scope="module")
def installed(wheels: list[str], tmp_path_factory: pytest.TempPathFactory) -> Installed:
    """An environment with both wheels, which no test changes."""
    return install(tmp_path_factory.mktemp("venv"), wheels)


def test_what_runs_are_the_wheels(installed: Installed, tmp_path: Path) -> None:
    said = installed.run(
        "-c", "import acoexp, acoexp_shy; print(acoexp.__file__, acoexp_shy.__file__)", cwd=tmp_path
    )
    assert said.stdout.count(str(installed.packages)) == 2


def test_its_part_and_its_preset_run(installed: Installed, tmp_path: Path) -> None:
    installed.acoexp("diffusion=shy", "diffusion.keep=0.5", "algo=aco", *QUICK, cwd=tmp_path)
    installed.acoexp("algo=shy", "iterations=5", "tracking=none", cwd=tmp_path)
    configs = [trial["config"] for trial in trials(tmp_path)]
    assert {(c["algo"], c["diffusion.keep"], c["ants"]) for c in configs} == {
        ("custom", "0.5", "3"),
        ("shy", "0.98", "10"),
    }


def test_the_papers_report_comes_with_the_wheel(installed: Installed, tmp_path: Path) -> None:
    installed.acoexp(
        "report=paper",
        "report.trials=10",
        "report.ensemble_trials=0",
        "report.reading_trials=0",
        *QUICK,
        cwd=tmp_path,
    )
    assert (tmp_path / "outputs/reports/paper/index.html").stat().st_size > 100_000


def test_the_page_that_plays_a_trial_comes_with_the_wheel(installed: Installed, tmp_path: Path) -> None:
    installed.acoexp("report=watch", "algo=aco", *QUICK, cwd=tmp_path)
    page = (tmp_path / "outputs/reports/watch/index.html").read_text(encoding="utf-8")
    assert "window.acoexp = {" in page
    assert "{{" not in page


def test_it_is_swept_and_tracked_beside_a_built_in_one(installed: Installed, tmp_path: Path) -> None:
    table = installed.acoexp("algo=shy,pdg", "map=env2", "-m", "seed=0-2", "iterations=5", cwd=tmp_path)
    assert "shy" in table
    client = MlflowClient(f"sqlite:///{tmp_path}/outputs/mlflow.db")
    experiment = client.get_experiment_by_name("acoexp")
    assert experiment is not None
    runs = client.search_runs([experiment.experiment_id])
    assert sorted((run.data.params["algo"], run.data.params["diffusion.name"]) for run in runs) == [
        *[("pdg", "gaussian")] * 3,
        *[("shy", "shy")] * 3,
    ]
    assert all(run.data.metrics["l1"] >= run.data.metrics["optimum"] for run in runs)


def test_it_is_compared_with_a_built_in_one(installed: Installed, tmp_path: Path) -> None:
    cells = 'report.cells=[shy,"aco diffusion=shy diffusion.keep=0.9",pdg]'
    installed.acoexp("report=compare", cells, "report.trials=5", "iterations=5", cwd=tmp_path)
    table = (tmp_path / "outputs/reports/compare/cells.csv").read_text(encoding="utf-8")
    assert table.count("shy") >= 2
    assert "pdg" in table


def test_python_knows_its_preset_too(installed: Installed, tmp_path: Path) -> None:
    said = installed.run("-c", "import acoexp; print(acoexp.solve('env2', 'shy', iterations=5))", cwd=tmp_path)
    assert said.stdout.startswith("<shy on env2"), said.stderr


def test_it_stands_in_the_help_and_in_the_list_of_parts(installed: Installed, tmp_path: Path) -> None:
    assert "diffusion.keep: share of an edge's pheromone that stays [0.99]" in installed.acoexp(
        "--help", cwd=tmp_path
    )
    parts = installed.acoexp("--info", "strategies", cwd=tmp_path)
    assert "shy  package acoexp-shy 1.0.0, contract 1, acoexp_shy.shy:Shy" in parts
    assert "shy  package acoexp-shy 1.0.0: heuristic=goal_distance" in parts


def test_its_own_tests_pass(installed: Installed, tmp_path: Path) -> None:
    shutil.copytree(EXAMPLE / "tests", tmp_path / "tests")
    ended = installed.run("-m", "pytest", "-q", "-s", "tests", cwd=tmp_path)
    assert ended.returncode == 0, ended.stdout
    assert "ns per ant step" in ended.stdout


def test_renamed_as_its_readme_says_it_is_a_package_of_its_own(installed: Installed, tmp_path: Path) -> None:
    copy = tmp_path / "plugins"
    shutil.copytree(EXAMPLE, copy / EXAMPLE.name)
    rename = re.findall(r"```bash\n(.*?)```", (EXAMPLE / "README.md").read_text("utf-8"), re.S)[1]
    subprocess.run(["bash", "-euo", "pipefail", "-c", rename], cwd=copy, check=True)
    package = copy / "acoexp-mine"
    texts = {file: file.read_text("utf-8") for file in package.rglob("*") if file.is_file()}
    assert not [file for file, text in texts.items() if re.search("shy", f"{file.relative_to(copy)}{text}", re.I)]

    project = tomllib.loads(texts[package / "pyproject.toml"])["project"]
    entries = "".join(
        f"[{group}]\n" + "".join(f"{name} = {value}\n" for name, value in values.items())
        for group, values in project["entry-points"].items()
    )
    there = install_package(package / "src", project["name"], entries, {})
    ended = installed.run(
        "-m", "pytest", "-q", "-k", "not (cost or bounds or without)", "tests", cwd=package, env=there
    )
    assert ended.returncode == 0, ended.stdout
    ended = installed.run("-m", "acoexp", "algo=mine", *QUICK, cwd=tmp_path, env=there)
    assert ended.returncode == 0, ended.stderr
    assert [trial["config"]["diffusion.name"] for trial in trials(tmp_path)] == ["mine"]


def test_half_uninstalled_it_harms_nobody(wheels: list[str], tmp_path: Path) -> None:
    installed = install(tmp_path / "venv", wheels)
    shutil.rmtree(installed.packages / "acoexp_shy")
    installed.acoexp("algo=pdg", *QUICK, cwd=tmp_path)
    message = installed.refusal("algo=aco", "diffusion=shy", *QUICK, cwd=tmp_path)
    assert "diffusion 'shy' of package acoexp-shy 1.0.0 cannot be imported" in message


def test_once_uninstalled_it_is_as_if_it_had_never_been(wheels: list[str], tmp_path: Path) -> None:
    installed = install(tmp_path / "venv", wheels)
    pip("--python", str(installed.python), "uninstall", "--yes", "acoexp-shy")
    installed.acoexp("algo=pdg", *QUICK, cwd=tmp_path)
    for option in ("algo=shy", "diffusion=shy"):
        message = installed.refusal(option, *QUICK, cwd=tmp_path)
        assert message.startswith(f"acoexp: error: {option.partition('=')[0]}: expected one of: ")
