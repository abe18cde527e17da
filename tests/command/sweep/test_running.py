"""A job of a sweep in this process: all is as with Hydra's own launcher."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from running import run_acoexp

CALLBACK = """
from pathlib import Path
from hydra.core.hydra_config import HydraConfig
from hydra.experimental.callback import Callback
from omegaconf import OmegaConf
import os


class Noting(Callback):
    def note(self, *said):
        with Path(os.environ["NOTES"]).open("a") as notes:
            print(*said, sep="\\n", file=notes)

    def on_job_start(self, config, **_):
        self.note(OmegaConf.to_yaml(config), os.getcwd(), os.environ["OF_JOB"])

    def on_job_end(self, config, job_return, **_):
        self.note(OmegaConf.to_yaml(config), job_return.overrides, OmegaConf.to_yaml(job_return.cfg))
        self.note(OmegaConf.to_yaml(job_return.hydra_cfg), job_return.status, job_return.working_dir)
        self.note(job_return.task_name, OmegaConf.to_yaml(HydraConfig.get()), config.hydra.sweep.subdir)
"""
SWEEP = (
    "-m", "seed=0-3", "algo=aco", "iterations=2", "ants=2", "tracking=none",
    "hydra.sweep.dir=out", "hydra.run.dir=alone",
    "hydra.sweep.subdir='${seed}-${hydra.job.override_dirname}-${hydra.job.num}'", "hydra.job.chdir=true",
    "+hydra.job.env_set.OF_JOB='job ${hydra.job.id}'", "+hydra.callbacks.noting._target_=noting.Noting",
)  # fmt: skip


def told(launcher: str, home: Path) -> dict[str, str]:
    """Return what a sweep leaves and what a callback sees, by file, without what has to differ."""
    (home / "noting.py").write_text(CALLBACK, encoding="utf-8")
    notes = {"PYTHONPATH": str(home), "NOTES": str(home / "notes.txt")}
    ended = run_acoexp(*SWEEP, f"hydra/launcher={launcher}", cwd=home, env=notes)
    assert ended.returncode == 0, ended.stderr
    files = [home / "notes.txt", *home.glob("out/**/.hydra/*"), *home.glob("out/**/config.yaml")]
    files += [folder for folder in home.glob("out/**/") if folder.name != "maps"]
    return {
        str(file.relative_to(home)): "" if file.is_dir() else without_launcher(file.read_text(), home)
        for file in files
    }


def without_launcher(text: str, home: Path) -> str:
    text = re.sub(r"_target_: hydra\S+Launcher\b|launcher[:=] ?\w+", "", text)
    text = re.sub(r"seconds: \S+|[0-9a-f]{16}", "", text)
    return text.replace(str(home), "HOME")


@pytest.mark.slow_without_jit
def test_files_folders_and_what_a_callback_sees_are_those_of_hydras_basic_launcher(tmp_path: Path) -> None:
    homes = [tmp_path / name for name in ("basic", "acoexp")]
    for home in homes:
        home.mkdir()
    hydras, ours = (told(home.name, home) for home in homes)
    assert len(ours["notes.txt"]) > 10_000
    assert ours == hydras
