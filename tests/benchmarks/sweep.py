"""What a trial of a sweep costs beside what MLflow takes to keep one, by turns.

All is processor time, so that a machine with other work to do may measure it. Of a sweep, it is what each trial
after the first adds to the command.

python tests/benchmarks/sweep.py [ROUNDS]
"""

from __future__ import annotations

import subprocess
import sys
from resource import RUSAGE_CHILDREN, getrusage
from statistics import median
from tempfile import TemporaryDirectory

TRIALS = 200
SWEEP = ["-m", "acoexp", "algo=pdg", "map=env2", "-m"]
ALONE = f"""
import time
from mlflow.entities import Param
from acoexp import load_map, solve_many
from acoexp.registry.resolve import resolve
from acoexp.tracking.mlflow.content import trial_metrics
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup
tracker = MlflowTracker("sqlite:///outputs/mlflow.db")
tracker.prepare()
client, experiment = tracker.store.client, tracker.store.experiment_id
setup = Setup.of(resolve("pdg", {{}}), load_map("env2"))
results = solve_many(setup.grid, "pdg", range({TRIALS}))
kept = [(list(trial_metrics(r, 0.001)), tracker._writer(setup, "seed", r.seed, True)) for r in results]
began = time.process_time()
for metrics, writer in kept:
    run = client.create_run(experiment, None, writer._tags, writer._name)
    client.log_batch(run.info.run_id, metrics, [Param(*pair) for pair in writer._params.items()])
    client.set_terminated(run.info.run_id)
print(time.process_time() - began)
"""


def command_seconds(seeds: str, folder: str) -> float:
    """Return the processor time of a sweep."""
    began = getrusage(RUSAGE_CHILDREN)
    subprocess.run([sys.executable, *SWEEP, f"seed={seeds}"], cwd=folder, check=True, capture_output=True)
    ended = getrusage(RUSAGE_CHILDREN)
    return ended.ru_utime + ended.ru_stime - began.ru_utime - began.ru_stime


def store_seconds(folder: str) -> float:
    """Return the processor time of MLflow's three calls for each trial, with what a trial's run says."""
    said = subprocess.run([sys.executable, "-c", ALONE], cwd=folder, check=True, capture_output=True, text=True)
    return float(said.stdout) / TRIALS


def trial_seconds(folder: str) -> float:
    """Return what a further trial of a sweep takes."""
    return (command_seconds(f"0-{TRIALS}", folder) - command_seconds(f"{TRIALS + 1}", folder)) / TRIALS


def measured(rounds: int) -> list[tuple[float, float]]:
    """Return what a trial takes in a sweep, and its keeping alone, for each round."""
    pairs = []
    for _ in range(rounds):
        with TemporaryDirectory() as folder:
            command_seconds(f"{TRIALS + 2}", folder)  # makes the store, and compiles
            pairs.append((trial_seconds(folder), store_seconds(folder)))
    return pairs


def main(rounds: int) -> None:
    """Print a table."""
    pairs = measured(rounds)
    sweep, store = (median(seconds) for seconds in zip(*pairs, strict=True))
    ratio = median(a / b for a, b in pairs)
    print("| | processor time a trial | ratio | aim |\n|---|---|---|---|")
    print(f"| create_run, log_batch, set_terminated | {1000 * store:.1f} ms | 1 | |")
    print(f"| a trial of `-m seed=0-{TRIALS - 1}` | {1000 * sweep:.1f} ms | {ratio:.2f} | 1.5 |")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
