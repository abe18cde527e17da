"""What a command costs before and after its trial: processor time, warm, by turns."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from rows import Given, Row
from timing import interleave, processor_seconds

ROUNDS = 9
SKELETON = str(Path(__file__).with_name("skeleton.py"))
COMMANDS = {
    "import hydra, numba": ["-c", "import hydra, numba"],
    "--help": ["-m", "acoexp", "--help"],
    "--cfg job": ["-m", "acoexp", "--cfg", "job"],
    "skeleton of a trial": [SKELETON],
    "one trial": ["-m", "acoexp"],
}
LIMITS = [("--help", "import hydra, numba", 3.0), ("--cfg job", "import hydra, numba", 3.0)]
LIMITS += [("one trial", "skeleton of a trial", 1.05)]


def rows(given: Given) -> Iterator[Row | str]:
    """Yield what commands take, each beside the least that it could."""
    with tempfile.TemporaryDirectory() as folder:
        jobs = {
            name: lambda arguments=arguments: processor_seconds([sys.executable, *arguments], folder)
            for name, arguments in COMMANDS.items()
        }
        interleave(1, jobs)  # makes the store, and may compile
        timing = interleave(given.rounds or ROUNDS, jobs)
    for name, base, aim in LIMITS:
        yield timing.row(name, base, unit="s", aim=aim)
