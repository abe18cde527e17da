"""Fuzzing: valid files of every format of a map, mutated at random, with a seed, and read.

    python tests/fuzz.py --inputs 100000 --seed 1

Whatever a file holds, it is a map or a ``MapError`` of one line, soon. At the first thing that is wrong it says
which, leaves the files, and ends with status 1; the last files lie there too if reading ends the process. An input
is drawn from the seed and its number alone, so that ``--first`` begins anywhere.
"""

from __future__ import annotations

import argparse
import random
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from pathlib import Path
from types import FrameType

sys.path.insert(0, str(Path(__file__).parent / "support"))

from mutations import FORMATS, mutated

from acoexp import MapError

SLOW = 5
"""Seconds of a processor that reading a small file may take; waiting, ten times that."""
LONGEST = 2000
"""Characters that a message may have."""


class SlowError(BaseException):
    """Reading took too long; not an Exception, so that nobody takes it for a broken file."""


def main() -> None:
    """Read mutated files until there were enough, or one is wrong."""
    parser = argparse.ArgumentParser(description="Mutate files of every format of a map and read them.")
    parser.add_argument("--inputs", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--formats", nargs="*", default=list(FORMATS), choices=list(FORMATS), metavar="FORMAT")
    arguments = parser.parse_args()
    memory = Path("/dev/shm")
    folder = Path(tempfile.mkdtemp(prefix="fuzz-", dir=memory if memory.is_dir() else None))
    for kind in (signal.SIGALRM, signal.SIGPROF):
        signal.signal(kind, too_slow)
    outcomes: Counter[str] = Counter()
    print(f"files lie in {folder}", flush=True)
    for sample in FORMATS.values():  # which also imports what reading them takes
        sample.load(folder, sample.files)
    began, slowest = time.monotonic(), (0.0, 0)
    for number in range(arguments.first, arguments.first + arguments.inputs):
        draw = random.Random(f"{arguments.seed} {number}")
        name = draw.choice(arguments.formats)
        start = time.monotonic()
        try:
            outcomes[f"{name}: {read(name, draw, folder)}"] += 1
        except BaseException as problem:
            if isinstance(problem, KeyboardInterrupt):
                raise
            traceback.print_exc()
            print(f"input {number}, seed {arguments.seed}, {name}: {type(problem).__name__}; left in {folder}")
            sys.exit(1)
        slowest = max(slowest, (time.monotonic() - start, number))
    seconds = time.monotonic() - began
    for outcome, count in sorted(outcomes.items()):
        print(f"{count:8} {outcome}")
    rate = f"{arguments.inputs} inputs, {arguments.inputs / seconds:.0f} a second"
    print(f"{rate}, the slowest {slowest[0]:.2f} s, number {slowest[1]}")
    shutil.rmtree(folder)


def read(name: str, draw: random.Random, folder: Path) -> str:
    """Read mutated files of a format; return whether they are a map, or are refused as they should."""
    files = mutated(draw, FORMATS[name].files)
    signal.setitimer(signal.ITIMER_PROF, SLOW)
    signal.alarm(10 * SLOW)
    try:
        FORMATS[name].load(folder, files)
    except MapError as problem:
        said = str(problem)
        if not said.isprintable() or len(said) > LONGEST:
            raise AssertionError(f"a message that no terminal should show: {said!r}") from problem
        return "refused"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.alarm(0)
    return "a map"


def too_slow(signal: int, frame: FrameType | None) -> None:
    """End what takes too long."""
    raise SlowError(f"more than {SLOW} s")


if __name__ == "__main__":
    main()
