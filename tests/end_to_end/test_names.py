"""Folders and files may be called as people call them: nothing is lost, nothing vanishes from the screen."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from running import QUICK, environment, listing, records, refusal, run_acoexp

from acoexp.command.options.quoting import hydra_text

NAMES = [
    "q?x=1", "a%2Fb", "[run]", "x[", "$^$", "a'b", 'a"b', "2024.05.01", "2024_05", "my map (1)", "a=b", "a,b",
    ":smile:", "a  b", "ü 中", "a${",
]  # fmt: skip

MAP = "S...\n.##.\n....\n...G\n"

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="bash, and names that Windows has not")


def check(ended: subprocess.CompletedProcess[str]) -> None:
    """Look that a command has nothing to say but that it compiles, which it may have to."""
    said = [line for line in ended.stderr.splitlines() if "compiling the colony" not in line]
    assert (ended.returncode, said) == (0, [])


def words(line: str, cwd: Path) -> list[str]:
    """Return the words that bash makes of a line."""
    done = subprocess.run(["bash", "-c", f"printf '%s\\0' {line}"], cwd=cwd, capture_output=True, check=True)
    return [os.fsdecode(word) for word in done.stdout.split(b"\0")[:-1]]


@pytest.mark.parametrize("name", NAMES)
def test_a_map_is_run_under_its_name_with_the_line_that_the_refusal_shows(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(MAP, encoding="utf-8")
    given = run_acoexp("map=file", f"map.path={name}", *QUICK, cwd=tmp_path)
    if given.returncode != 0:
        assert given.stderr.startswith("acoexp: error: map.path")
        assert listing(tmp_path) == {name}
        (typed,) = words(given.stderr.rstrip("\n").partition("type ")[2], tmp_path)
        given = run_acoexp("map=file", typed, *QUICK, cwd=tmp_path)
    check(given)
    assert f"pdg  {name} " in given.stdout
    (record,) = records(tmp_path)
    assert json.loads(record.read_text("utf-8"))["map"] == name
    assert {path.name for path in record.parent.iterdir()} >= {"path.png", "convergence.png"}


@pytest.mark.parametrize("name", ["a%20b#c %/[run] [b]/a'b\\c", "a?b=1&c/$^$/my maps (1), ü 中"])
def test_in_a_folder_of_any_name_a_sweep_leaves_everything_there(name: str, tmp_path: Path) -> None:
    folder = tmp_path / name
    folder.mkdir(parents=True)
    ended = run_acoexp("rho=0.1,0.2", "-m", *QUICK, "tracking=mlflow", cwd=folder)
    check(ended)
    assert (folder / "outputs" / "mlflow.db").is_file()
    assert f"files: {folder}/outputs/sweeps/" in ended.stdout
    assert len(records(folder)) == 2
    above = {folder, *folder.parents}
    assert [path for path in tmp_path.rglob("*") if path not in above and folder not in path.parents] == []


@pytest.mark.parametrize("name", ["x[/a'b\\c", "2024_05/$^$ *, ü 中"])
@pytest.mark.parametrize(("key", "sweep"), [("hydra.run.dir", []), ("hydra.sweep.dir", ["-m", "rho=0.1,0.2"])])
def test_a_run_and_a_sweep_lie_where_they_are_told(name: str, key: str, sweep: list[str], tmp_path: Path) -> None:
    ended = run_acoexp(f"{key}={hydra_text(f'all/{name}')}", *sweep, *QUICK, cwd=tmp_path)
    check(ended)
    assert f"all/{name}\n" in ended.stdout
    assert {path.parents[1 if sweep else 0] for path in records(tmp_path)} == {tmp_path / "all" / name}


@pytest.mark.parametrize("name", ["${b}", "\udcff"])
def test_a_folder_that_hydra_would_misread_is_refused_at_once(name: str, tmp_path: Path) -> None:
    folder = tmp_path / name
    folder.mkdir()
    assert "working directory" in refusal(*QUICK, cwd=folder)


def test_what_a_message_proposes_can_be_pasted_into_a_shell(tmp_path: Path) -> None:
    """With everything that a person's shell does, once."""
    (tmp_path / 'it\'s my "map" (1) ${b}.txt').write_text(MAP, encoding="utf-8")

    def shell(line: str) -> subprocess.CompletedProcess[str]:
        command = ["bash", "-c", f"{sys.executable} -m acoexp map=file {line} {' '.join(QUICK)}"]
        return subprocess.run(
            command, cwd=tmp_path, env=environment(), capture_output=True, text=True, check=False
        )

    said = shell(r"""map.path=it\'s\ my\ \"map\"\ \(1\)\ \$\{b\}.txt""")
    assert said.returncode == 1
    line = said.stderr.rstrip("\n").partition("; type ")[2]
    assert shell(line).returncode == 0, line
