"""What a command costs before and after its trial: CPU seconds, warm, interleaved, medians.

python tests/benchmarks/startup.py [ROUNDS]
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

SKELETON = str(Path(__file__).with_name("skeleton.py"))
COMMANDS = {
    "import hydra, numba": ["-c", "import hydra, numba"],
    "--help": ["-m", "acoexp", "--help"],
    "--cfg job": ["-m", "acoexp", "--cfg", "job"],
    "skeleton of a trial": [SKELETON],
    "one trial": ["-m", "acoexp"],
}
LIMITS = [("--help", "import hydra, numba", 3.0), ("--cfg job", "import hydra, numba", 3.0)]
LIMITS += [("one trial", "skeleton of a trial", 1.35)]


def cpu_seconds(arguments: list[str], folder: str) -> float:
    before = os.times()
    subprocess.run([sys.executable, *arguments], cwd=folder, check=True, capture_output=True)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def main(rounds: int) -> None:
    spent: dict[str, list[float]] = {name: [] for name in COMMANDS}
    with tempfile.TemporaryDirectory() as folder:
        for turn in range(rounds + 1):
            for name, arguments in COMMANDS.items():
                seconds = cpu_seconds(arguments, folder)
                if turn > 0:  # the first one creates the store and may compile
                    spent[name].append(seconds)
    print("| command | CPU seconds | ratio | aim |\n|---|---|---|---|")
    for name, base, limit in LIMITS:
        ratio = median(a / b for a, b in zip(spent[name], spent[base], strict=True))
        print(f"| `{name}` | {median(spent[name]):.2f} | {ratio:.2f} x {base} | {limit:g} |")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 9)
