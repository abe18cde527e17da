"""Twelve thousand trials as twelve batches, tracked: wall time, and peak memory of the whole process tree.

python tests/benchmarks/batches.py [seeds]
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil

SWEEP = ["algo=aco,pd,pdg,pf", "map=fig13,env1,env2", "-m"]


def main() -> None:
    """Run the sweep twice, to have its kernels compiled, and print what the second one took."""
    seeds = sys.argv[1] if len(sys.argv) > 1 else "0-999"
    with tempfile.TemporaryDirectory() as warm, tempfile.TemporaryDirectory() as home:
        run(Path(warm), "0-1")
        seconds, peak = run(Path(home), seeds)
    print(f"12 batches, seeds {seeds}: {seconds:.1f} s, {peak / 1e6:.0f} MB")


def run(home: Path, seeds: str) -> tuple[float, int]:
    """Return the seconds that a sweep took, and the most memory that its processes held at once."""
    began, peak = time.perf_counter(), 0
    process = subprocess.Popen([sys.executable, "-m", "acoexp", *SWEEP, f"seeds={seeds}"], cwd=home)
    watched = psutil.Process(process.pid)
    while process.poll() is None:
        try:
            peak = max(peak, sum(p.memory_info().rss for p in [watched, *watched.children(recursive=True)]))
        except psutil.NoSuchProcess:
            continue
        time.sleep(0.02)
    if process.returncode:
        sys.exit(process.returncode)
    return time.perf_counter() - began, peak


if __name__ == "__main__":
    main()
