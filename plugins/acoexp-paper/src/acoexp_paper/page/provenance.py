"""What the report was made with: versions, the code as it was, how many trials."""

from __future__ import annotations

import platform
from functools import cache
from importlib.metadata import version
from pathlib import Path
from subprocess import DEVNULL, SubprocessError, check_output

import acoexp
from acoexp.kernels.digest import digest_of_sources
from acoexp.report.table import Table
from acoexp_paper.page.document import Block, Numbers
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.readings import trials_of_readings

_PACKAGES = ("acoexp", "numpy", "numba", "scipy", "matplotlib")
_NOTE = (
    "The same command with the same of these writes the same bytes. What it took is therefore not here, but in "
    "time.json beside this page."
)


def provenance(experiment: Experiment) -> list[Block]:
    """Return the table of what the report was made with."""
    rows = [[what, text] for what, text in made_with(experiment).items()]
    return [Numbers("provenance", Table("What this was made with.", _NOTE, ["what", ""], rows))]


def made_with(experiment: Experiment) -> dict[str, str]:
    """Return what the numbers of the report depend on, in words: nothing that another run would change."""
    return {
        **{package: version(package) for package in _PACKAGES},
        "Python": platform.python_version(),
        "commit": _commit() or "not in a repository",
        "digest of acoexp's sources": (digest_of_sources("acoexp") or "-")[:16],
        "seeds": "; ".join(
            f"{where} 0 to {trials - 1}"
            for where, trials in (
                ("on each environment's own map", experiment.trials),
                ("on the further maps", experiment.ensemble_trials),
                ("under other readings", experiment.reading_trials),
            )
            if trials
        ),
        "trials": f"{experiment.size + trials_of_readings(experiment)}",
    }


@cache
def _commit() -> str | None:
    """Return the commit of acoexp's code, ``-dirty`` if the tree has changes; None if it is in no repository."""
    folder = Path(acoexp.__file__).parent
    try:
        check_output(["git", "ls-files", "--error-unmatch", "__init__.py"], cwd=folder, stderr=DEVNULL, timeout=5)
        described = ["git", "describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"]
        return check_output(described, cwd=folder, stderr=DEVNULL, text=True, timeout=5).strip()
    except (OSError, SubprocessError):
        return None
