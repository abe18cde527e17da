"""The database of a study: its own, and made by one of several processes that begin at once."""

from __future__ import annotations

import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from running import environment

from acoexp.command.tuning.opening import distribution, storage_at
from acoexp.command.tuning.space import Choice, Numbers
from acoexp.errors import SettingsError
from acoexp.tracking.mlflow.store import Store

optuna = pytest.importorskip("optuna")

AT_ONCE = 4


def test_values_are_what_optuna_calls_them() -> None:
    of = optuna.distributions
    assert distribution(Numbers(0.1, 0.9)) == of.FloatDistribution(0.1, 0.9)
    assert distribution(Numbers(0.1, 0.9, step=0.2)) == of.FloatDistribution(0.1, 0.9, step=0.2)
    assert distribution(Numbers(0.1, 0.9, log=True)) == of.FloatDistribution(0.1, 0.9, log=True)
    assert distribution(Numbers(1, 8, step=1)) == of.IntDistribution(1, 8)
    assert distribution(Numbers(1, 8, log=True)) == of.IntDistribution(1, 8, log=True)
    assert distribution(Choice(("aco", "pd"))) == of.CategoricalDistribution(("aco", "pd"))


def test_another_programs_database_is_refused_and_left_as_it_is(tmp_path: Path) -> None:
    file = tmp_path / "mlflow.db"
    with sqlite3.connect(file) as connection:
        connection.execute("CREATE TABLE alembic_version (version_num VARCHAR(32))")
    before = file.read_bytes()
    with pytest.raises(SettingsError, match=r"^hydra\.sweeper\.storage: expected a database of its own"):
        storage_at(Store(f"sqlite:///{file}"))
    assert file.read_bytes() == before


def test_several_processes_begin_at_once(tmp_path: Path) -> None:
    code = (
        "import sys; from acoexp.command.tuning.opening import storage_at; import optuna; "
        "from acoexp.tracking.mlflow.store import Store; sys.stdin.read(); storage_at(Store(sys.argv[1]))"
    )
    processes = [
        subprocess.Popen(
            [sys.executable, "-c", code, f"sqlite:///{tmp_path}/study.db"],
            env=environment(),
            stdin=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        for _ in range(AT_ONCE)
    ]
    said = [process.communicate(timeout=120.0)[1] for process in processes]
    assert [process.returncode for process in processes] == [0] * AT_ONCE, said
