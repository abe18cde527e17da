"""What each engine costs: one sweep of 40 trials through all of them, and the same metrics from each.

Runs a Slurm and a Ray cluster of its own, on loopback; what is not installed is left out.
"""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Iterator
from contextlib import nullcontext
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))

import servers
from rows import Given, Row
from running import run_acoexp, trials
from timing import Timing, seconds

import acoexp

ROUNDS, ALGOS, SEEDS = 3, ("aco", "pdg"), range(20)
JOBS = len(ALGOS) * len(SEEDS)
ENGINES = {
    "basic": lambda: nullcontext({}),
    "joblib": lambda: nullcontext({}),
    "slurm": servers.slurm,
    "ray": servers.ray,
}


def sweep(engine: str, env: dict[str, str], seeds: str, folder: Path) -> None:
    """Run a sweep."""
    folder.mkdir()
    arguments = (f"engine={engine}", f"algo={','.join(ALGOS)}", f"seed={seeds}", "tracking=none")
    ended = run_acoexp("-m", *arguments, cwd=folder, env=env, timeout=900.0)
    if ended.returncode:
        raise servers.NoServerError(ended.stderr.splitlines()[-1])


def same_as_here(folder: Path) -> bool:
    """Tell whether a sweep found what each trial finds in this process."""
    found = {(trial["algo"], trial["seed"]): trial for trial in trials(folder)}
    here = {(a, s): json.loads(json.dumps(acoexp.solve("fig13", a, s).as_dict())) for a in ALGOS for s in SEEDS}
    return found.keys() == here.keys() and all(
        found[key][name] == value for key, values in here.items() for name, value in values.items()
    )


def per_trial(engine: str, env: dict[str, str], scratch: Path, turn: int) -> tuple[float, bool]:
    """Return the seconds that each trial adds after an algorithm's first, and whether metrics are the same."""
    few = seconds(lambda: sweep(engine, env, "0", scratch / f"few-{turn}"))
    whole = seconds(lambda: sweep(engine, env, f"0-{SEEDS[-1]}", scratch / f"all-{turn}"))
    return (whole - few) / (JOBS - len(ALGOS)), same_as_here(scratch / f"all-{turn}")


def rows(given: Given) -> Iterator[Row | str]:
    """Yield a row for each engine, beside Hydra's own, which takes turns with it."""
    for engine, server in ENGINES.items():
        timing, same = Timing({"basic": [], engine: []}), True
        try:
            with server() as env, tempfile.TemporaryDirectory() as scratch:
                sweep(engine, env, "0", Path(scratch, "first"))  # compiles
                for turn in range(given.rounds or ROUNDS):
                    for one in timing:
                        (place := Path(scratch, one)).mkdir(exist_ok=True)
                        found, as_here = per_trial(one, env, place, turn)
                        timing[one].append(found)
                        same = same and as_here
        except servers.NoServerError as problem:
            yield f"{engine}: {problem}"
            continue
        base = "" if engine == "basic" else "basic"
        note = "the same metrics" if same else "**OTHER METRICS**"
        yield timing.row(engine, base, unit="ms", name=f"{engine}, a trial of {JOBS}", note=note)
