"""All benchmarks, in one table of ratios within one run, compared with the last that was committed.

    python tests/benchmarks                      # all of them
    python tests/benchmarks speed large          # these alone
    python tests/benchmarks --json tests/benchmarks/last.json

Both sides of a ratio are measured by turns, and the median of the rounds' ratios is shown. Run it on an idle
machine. What needs something that is not there is left out, with a line that says so.
"""

from __future__ import annotations

import argparse
import json
from importlib import import_module
from pathlib import Path

from rows import Given, Row
from table import HEADING, find, line, read, write

LAST = Path(__file__).with_name("last.json")
NAMES = (
    *("speed", "large", "startup", "sweep", "batches", "plugin", "recording"),
    *("engines", "tracked", "nav", "ablation", "scenarios"),
)


def main() -> None:
    """Run what was asked for and print the table as it comes to be."""
    parser = argparse.ArgumentParser(prog="python tests/benchmarks", description=str(__doc__).partition("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"some of: {', '.join(NAMES)}; all by default")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the rows to a file, too")
    parser.add_argument("--rounds", type=int, metavar="N", help="how often both sides of a ratio are measured")
    parser.add_argument(
        "--worktree", type=Path, metavar="FOLDER", help="another version of acoexp to compare with"
    )
    parser.add_argument("--maps", type=Path, metavar="FOLDER", help="maps and scenarios of MovingAI, or of ROS")
    asked = parser.parse_args()
    unknown = sorted({*asked.names} - {*NAMES})
    if unknown:
        parser.error(f"NAME: expected some of: {', '.join(NAMES)}; got {unknown[0]!r}")
    if asked.rounds is not None and asked.rounds < 1:
        parser.error(f"--rounds: expected a whole number from 1; got {asked.rounds}")
    try:
        last = read(LAST)
        _ = asked.json and read(asked.json)  # before an hour of measuring
    except (OSError, json.JSONDecodeError, TypeError, AttributeError) as problem:
        parser.error(f"expected rows that this program wrote; {problem}")
    given = Given(rounds=asked.rounds, worktree=asked.worktree, maps=asked.maps)
    measured: dict[str, list[Row]] = {}
    left_out = []
    print(HEADING, flush=True)
    for name in asked.names or NAMES:
        for found in import_module(name).rows(given):
            if isinstance(found, str):
                left_out.append(f"left out: {name}: {found}")
                continue
            measured.setdefault(name, []).append(found)
            print(line(name, found, find(last, name, found.name)), flush=True)
        if asked.json:
            write(asked.json, measured)
    if left_out:
        print("", *left_out, sep="\n")


if __name__ == "__main__":
    main()
