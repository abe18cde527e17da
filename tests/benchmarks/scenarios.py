"""Whether the exact optimum equals the published one, in every row of every scenario of the MovingAI benchmarks.

A row differs if it does by more than the digits that are printed.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from rows import Given, Row

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


def rows(given: Given) -> Iterator[Row | str]:
    """Yield for each scenario how many of its rows agree."""
    if given.maps is None:
        yield "no --maps"
        return
    for scenario in sorted(given.maps.glob("*.scen")):
        count, wrong = differing(scenario)
        agree = count - len(wrong)
        yield Row(
            name=scenario.name,
            value=agree,
            unit="rows agree",
            ratio=agree / count,
            base="all rows",
            aim=1.0,
            at_least=True,
            note="; ".join(wrong[:20]),
        )
