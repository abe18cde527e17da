"""What each engine costs: one sweep of 40 trials through all of them, and the same metrics from each.

python tests/benchmarks/engines.py

Runs a Slurm and a Ray cluster of its own, on loopback; what is not installed is left out.
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from contextlib import nullcontext
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))

import servers
from running import run_acoexp, trials

import acoexp

ALGOS, SEEDS = ("aco", "pdg"), range(20)
JOBS = len(ALGOS) * len(SEEDS)
ENGINES = {
    "basic": lambda: nullcontext({}),
    "joblib": lambda: nullcontext({}),
    "slurm": servers.slurm,
    "ray": servers.ray,
}


def seconds(engine: str, env: dict[str, str], seeds: str, folder: Path) -> float:
    """Return how long a sweep takes from the first to the last line."""
    folder.mkdir()
    began = time.perf_counter()
    arguments = (f"engine={engine}", f"algo={','.join(ALGOS)}", f"seed={seeds}", "tracking=none")
    ended = run_acoexp("-m", *arguments, cwd=folder, env=env, timeout=900.0)
    assert ended.returncode == 0, ended.stderr
    return time.perf_counter() - began


def same_as_here(folder: Path) -> bool:
    """Tell whether a sweep found what each trial finds in this process."""
    found = {(trial["algo"], trial["seed"]): trial for trial in trials(folder)}
    here = {(a, s): json.loads(json.dumps(acoexp.solve("fig13", a, s).as_dict())) for a in ALGOS for s in SEEDS}
    return found.keys() == here.keys() and all(
        found[key][name] == value for key, values in here.items() for name, value in values.items()
    )


def main() -> None:
    """Print the table."""
    print(f"| engine | {JOBS} trials | per trial | metrics |\n|---|---|---|---|")
    for engine, server in ENGINES.items():
        try:
            with server() as env, tempfile.TemporaryDirectory() as scratch:
                least = seconds(engine, env, "0", Path(scratch, "few"))  # compiles, and is what a start costs
                least = min(least, seconds(engine, env, "0", Path(scratch, "warm")))
                whole = seconds(engine, env, f"0-{SEEDS[-1]}", Path(scratch, "all"))
                same = "identical" if same_as_here(Path(scratch, "all")) else "DIFFERENT"
        except servers.NoServerError as problem:
            print(f"| {engine} | {problem} | | |")
            continue
        per_trial = 1000.0 * (whole - least) / (JOBS - len(ALGOS))
        print(f"| {engine} | {whole:.1f} s | {per_trial:.0f} ms | {same} |", flush=True)


if __name__ == "__main__":
    main()
