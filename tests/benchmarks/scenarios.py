"""Whether the exact optimum equals the published one, in every row of every scenario in a folder.

    python tests/benchmarks/scenarios.py FOLDER

FOLDER has scenarios of the MovingAI benchmarks with their maps. Prints a line a scenario, and rows that differ by
more than the digits that are printed; ends with status 1 if any does.
"""

from __future__ import annotations

import sys
from pathlib import Path

from acoexp.grid.moves import allowed_moves
from acoexp.grid.optimum import distances
from acoexp.maps.movingai import parse_instance, parse_obstacles


def precision(published: str) -> float:
    """Return by how much a printed number may differ from the true one: half of its last digit, or six digits."""
    decimals = len(published.partition(".")[2])
    return max(0.5 * 10.0**-decimals, 5e-6 * max(1.0, float(published))) * 1.01


def differing(scenario: Path) -> tuple[int, list[str]]:
    """Return how many rows a scenario has, and what is to be said of those that differ."""
    text = scenario.read_text(encoding="utf-8")
    rows = [line for line in text.split("\n")[1:] if line.strip()]
    map_file = scenario.with_name(parse_instance(text, 0, scenario.name).map)
    allowed = allowed_moves(parse_obstacles(map_file.read_text(encoding="utf-8"), map_file.name, "free"), "no_cut")
    found = []
    for number, row in enumerate(rows):
        instance, published = parse_instance(text, number, scenario.name), row.split()[-1]
        length = float(distances(allowed, instance.goal)[instance.start])
        if abs(length - instance.optimum) > precision(published):
            found.append(f"{scenario.name}, row {number}: {length:.8f}, published {published}")
    return len(rows), found


def main() -> None:
    """Look at every row."""
    wrong = []
    for scenario in sorted(Path(sys.argv[1]).glob("*.scen")):
        rows, found = differing(scenario)
        wrong += found
        print(f"{scenario.name}: {rows - len(found)} of {rows} rows agree", flush=True)
    print("\n".join(wrong[:20]))
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
