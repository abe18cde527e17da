"""An engine whose extra is not installed is refused in one line, before anything runs."""

from __future__ import annotations

from pathlib import Path

import pytest
from hydra_plugins.acoexp import sweeper
from running import QUICK, refusal


@pytest.mark.parametrize(
    ("argument", "name"),
    [
        ("engine=joblib", "joblib"),
        ("engine=slurm", "slurm"),
        ("engine=ray", "ray"),
        ("hydra/sweeper=optuna", "optuna"),
    ],
)
def test_a_missing_extra_is_named(argument: str, name: str, tmp_path: Path) -> None:
    (tmp_path / "hydra_plugins").mkdir()
    (tmp_path / "hydra_plugins" / "__init__.py").touch()  # hides those that are installed, but for our own
    (tmp_path / "hydra_plugins" / "acoexp").symlink_to(Path(sweeper.__file__).parent)
    (tmp_path / "optuna.py").write_text("raise ImportError", encoding="utf-8")
    message = refusal(
        "-m",
        "seed=0,1",
        argument,
        *QUICK,
        cwd=tmp_path,
        env={"PYTHONPATH": str(tmp_path), "PYTHONDONTWRITEBYTECODE": "1"},
    )
    assert message == f'{argument.partition("=")[0]}: {name} needs `pip install "acoexp[{name}]"`'
