"""What a trial of a sweep costs beside what MLflow takes to keep one, by turns.

All is processor time, so that a machine with other work to do may measure it. Of a sweep, it is what each trial
after the first adds to the command.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from tempfile import TemporaryDirectory

from rows import Given, Row
from timing import Timing, processor_seconds

ROUNDS, TRIALS = 5, 200
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
    return processor_seconds([sys.executable, *SWEEP, f"seed={seeds}"], folder)


def store_seconds(folder: str) -> float:
    """Return the processor time of MLflow's three calls for each trial, with what a trial's run says."""
    said = subprocess.run([sys.executable, "-c", ALONE], cwd=folder, check=True, capture_output=True, text=True)
    return float(said.stdout) / TRIALS


def trial_seconds(folder: str) -> float:
    """Return what a further trial of a sweep takes."""
    return (command_seconds(f"0-{TRIALS}", folder) - command_seconds(f"{TRIALS + 1}", folder)) / TRIALS


def rows(given: Given) -> Iterator[Row | str]:
    """Yield what keeping a trial takes, and a trial of a sweep beside it."""
    store, sweep = "MLflow's three calls", f"a trial of -m seed=0-{TRIALS - 1}"
    timing = Timing({store: [], sweep: []})
    for _ in range(given.rounds or ROUNDS):
        with TemporaryDirectory() as folder:
            command_seconds(f"{TRIALS + 2}", folder)  # makes the store, and compiles
            timing[sweep].append(trial_seconds(folder))
            timing[store].append(store_seconds(folder))
    yield timing.row(store, unit="ms")
    yield timing.row(sweep, store, unit="ms", aim=1.5)
