"""Chaos: commands are killed, interrupted, started at once, moved and run on a full disk, at random, with a seed.

    python tests/chaos.py --minutes 10 --seed 1

After each round it looks: nothing that was finished is lost, nothing is there twice, the store is sound, and the
exit statuses are true. At the end every trial is run, and held against ``acoexp.solve``. It prints a line for each
round, and ends with status 1 at the first thing that is wrong; the same seed makes the same rounds, though not the
same moments.
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "support"))

import acoexp

QUICK = {"iterations": 6, "ants": 3}
SETTINGS = [f"{key}={value}" for key, value in QUICK.items()]
SEEDS = 60
ALGOS = ("aco", "pd")
STATUSES = {0, 1, 130, -signal.SIGKILL, -signal.SIGTERM}
ENDED_WELL_OR_KILLED = {0, 130, -signal.SIGKILL, -signal.SIGTERM}


class WrongError(Exception):
    """Something is lost, twice, unsound or untrue."""


class Rounds:
    """A project folder, and what may happen to it."""

    def __init__(self, home: Path, seed: int) -> None:
        self.home, self.draw = home / "project", random.Random(seed)
        self.home.mkdir()
        self.finished: set[str] = set()
        self.moved = 0

    def run_one(self) -> str:
        """Let something happen, look at what is left, and return what it was."""
        happening: Callable[[], str] = self.draw.choice(
            [self.kill, self.kill, self.kill_fresh, self.at_once, self.move, self.fill, self.merge, self.let_run]
        )
        said = happening()
        self.look()
        return said

    def command(self) -> list[str]:
        """Return a sweep of some trials, or a batch of some."""
        first = self.draw.randrange(SEEDS - 5)
        last = self.draw.randrange(first + 1, SEEDS)
        key = self.draw.choice(["seed", "seed", "seeds"])
        return ["-m", f"algo={self.draw.choice(ALGOS)}", f"{key}={first}-{last}", *SETTINGS]

    def start(self, *arguments: str, home: Path | None = None) -> subprocess.Popen[str]:
        """Start a command in a session of its own."""
        return subprocess.Popen(
            [sys.executable, "-m", *(arguments or ("acoexp", *self.command()))],
            cwd=home or self.home,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )

    def end(self, process: subprocess.Popen[str], allowed: set[int]) -> int:
        """Wait for a command; refuse a status that is not true, and a traceback."""
        _, said = process.communicate(timeout=300)
        if process.returncode not in allowed:
            raise WrongError(f"status {process.returncode}: {said[-2000:]}")
        if "Traceback" in said and process.returncode >= 0:
            raise WrongError(f"a traceback: {said[-2000:]}")
        return process.returncode

    def strike(self, process: subprocess.Popen[str], after: float) -> str:
        """Kill, end or interrupt a command after a while."""
        blow = self.draw.choice([signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
        time.sleep(after)
        if process.poll() is None:
            os.killpg(process.pid, blow)
        return f"{blow.name} after {after:.1f} s: {self.end(process, ENDED_WELL_OR_KILLED)}"

    def kill(self) -> str:
        """Strike a sweep or a batch under way."""
        return self.strike(self.start(), self.draw.uniform(0.5, 8.0))

    def kill_fresh(self) -> str:
        """Strike while the store of another folder is made, which must then be usable."""
        with tempfile.TemporaryDirectory() as folder:
            home = Path(folder)
            said = self.strike(self.start("acoexp", *SETTINGS, home=home), self.draw.uniform(1.5, 7.0))
            self.end(self.start("acoexp", *SETTINGS, home=home), {0})
            check_sound(home)
        return f"a fresh store, {said}"

    def at_once(self) -> str:
        """Start several at once."""
        processes = [self.start() for _ in range(self.draw.randrange(2, 5))]
        return f"{len(processes)} at once: {[self.end(process, {0}) for process in processes]}"

    def move(self) -> str:
        """Move the whole folder."""
        self.moved += 1
        self.home = self.home.rename(self.home.with_name(f"project {self.moved}"))
        return f"moved to {self.home.name!r}"

    def fill(self) -> str:
        """Run on a disk that is too small."""
        size = self.draw.choice(["1m", "2m", "3m"])
        with tempfile.TemporaryDirectory() as folder, small_disk(Path(folder), size) as mounted:
            if not mounted:
                return "no disk to fill: that needs root"
            status = self.end(self.start("acoexp", *self.command(), home=Path(folder)), {0, 1})
        return f"a full disk: {status}"

    def merge(self) -> str:
        """Run elsewhere, bring it home, and strike that."""
        with tempfile.TemporaryDirectory() as folder:
            self.end(self.start("acoexp", *self.command(), home=Path(folder)), {0})
            source = str(Path(folder) / "outputs" / "mlflow.db")
            if not (self.home / "outputs" / "mlflow.db").exists():
                self.end(self.start(), {0})
            said = self.strike(self.start("acoexp.merge", source), self.draw.uniform(0.5, 6.0))
            self.end(self.start("acoexp.merge", source), {0})
        return f"merged, {said}"

    def let_run(self) -> str:
        """Let a command run to its end."""
        return f"undisturbed: {self.end(self.start(), {0})}"

    def look(self) -> None:
        """Refuse a store in which something is lost, twice or unsound."""
        if not (self.home / "outputs" / "mlflow.db").exists():
            return
        check_sound(self.home)
        identities = Counter(finished(self.home))
        # a command that was killed as it finished a run may leave two; the next one that asks leaves one of them
        now = set(identities)
        if not self.finished <= now:
            raise WrongError(f"{len(self.finished - now)} finished runs are lost")
        self.finished = now

    def finish(self) -> str:
        """Run every trial, and hold each against an undisturbed one."""
        for algo in ALGOS:
            self.end(self.start("acoexp", "-m", f"algo={algo}", f"seed=0-{SEEDS - 1}", *SETTINGS), {0})
            lengths = kept_lengths(self.home, algo)
            for result in acoexp.solve_many("fig13", algo, range(SEEDS), **QUICK):
                if lengths[result.seed] != ([] if result.path is None else [result.length]):
                    raise WrongError(
                        f"{algo}, seed {result.seed}: kept {lengths[result.seed]}, not {result.length}"
                    )
        return f"{2 * SEEDS} trials as undisturbed ones, each once"


@contextmanager
def small_disk(folder: Path, size: str) -> Iterator[bool]:
    """Mount a small disk, if this user may; tell whether that was so."""
    done = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)], capture_output=True, check=False
    )
    try:
        yield done.returncode == 0
    finally:
        if done.returncode == 0:
            subprocess.run(["umount", str(folder)], check=False)


def check_sound(home: Path) -> None:
    """Refuse a database that SQLite finds damaged."""
    with closing(sqlite3.connect(home / "outputs" / "mlflow.db")) as database:
        (verdict,) = database.execute("PRAGMA integrity_check").fetchone()
    if verdict != "ok":
        raise WrongError(f"the store is damaged: {verdict}")


def finished(home: Path) -> list[str]:
    """Return the identity of each finished run."""
    with closing(sqlite3.connect(home / "outputs" / "mlflow.db")) as database:
        rows = database.execute(
            "SELECT value FROM tags JOIN runs USING (run_uuid) WHERE key = 'identity' AND status = 'FINISHED' "
            "AND lifecycle_stage = 'active'"
        ).fetchall()
    return [identity for (identity,) in rows]


def kept_lengths(home: Path, algo: str) -> dict[int, list[float]]:
    """Return l1 of each finished single trial by its seed, a list with one number for each such run."""
    with closing(sqlite3.connect(home / "outputs" / "mlflow.db")) as database:
        rows = database.execute(
            "SELECT s.value, m.value FROM runs JOIN params s ON s.run_uuid = runs.run_uuid AND s.key = 'seed' "
            "JOIN params a ON a.run_uuid = runs.run_uuid AND a.key = 'algo' AND a.value = ? "
            "LEFT JOIN latest_metrics m ON m.run_uuid = runs.run_uuid AND m.key = 'l1' "
            "WHERE status = 'FINISHED' AND lifecycle_stage = 'active'",
            (algo,),
        ).fetchall()
    lengths: dict[int, list[float]] = {seed: [] for seed in range(SEEDS)}
    for seed, length in rows:
        if length is not None:
            lengths[int(seed)].append(length)
    return lengths


def main() -> None:
    """Make rounds until the time is over."""
    parser = argparse.ArgumentParser(description="Kill, fill, move and start acoexp at once, at random.")
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="chaos-"))
    rounds, began, number = Rounds(folder, arguments.seed), time.monotonic(), 0
    try:
        while time.monotonic() - began < 60.0 * arguments.minutes:
            number += 1
            print(f"{number:4} {time.monotonic() - began:6.0f} s  {rounds.run_one()}", flush=True)
        print(f"{number} rounds: {rounds.finish()}")
    except WrongError as problem:
        print(f"round {number}, seed {arguments.seed}: {problem}\nleft in {folder}")
        sys.exit(1)
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
