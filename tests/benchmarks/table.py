"""The one table of all benchmarks, in Markdown, and the file that the next run is compared with."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path

from rows import Row

Measured = Mapping[str, Sequence[Row]]
"""Rows by the benchmark's name."""

HEADING = "| benchmark | what | value | ratio | aim | last | |\n|---|---|---|---|---|---|---|"
LEAST_NOISE = 0.03
"""What a ratio may differ by, as a share, though all rounds of a run agree."""


def line(benchmark: str, row: Row, last: Row | None) -> str:
    """Return a row as a line of the table, with its mark and its note."""
    cells = [benchmark, row.name, f"{shown(row.value)} {row.unit}"]
    cells += ["" if row.ratio is None else f"{row.ratio:.2f} x {row.base}"]
    cells += ["" if row.aim is None else f"{'at least ' * row.at_least}{row.aim:g}"]
    cells += ["" if last is None else shown(last.compared) if last.ratio is None else f"{last.compared:.2f}"]
    return f"| {' | '.join([*cells, '; '.join([*marks(row, last), *filter(None, [row.note])])])} |"


def shown(value: float) -> str:
    """Return a number with three digits that count."""
    return f"{value:.0f}" if abs(value) >= 100.0 else f"{value:.3g}"


def marks(row: Row, last: Row | None) -> list[str]:
    """Return what is to be noticed: that an aim is missed, that it got worse by more than the noise."""
    found = []
    if row.aim is not None and is_worse(row.compared, row.aim, row.at_least, 0.0):
        found.append("**misses the aim**")
    if last is not None:
        noise = max(LEAST_NOISE, 2.0 * (row.spread + last.spread))
        if is_worse(row.compared, last.compared, row.at_least, noise):
            found.append("**worse**")
    return found


def is_worse(now: float, before: float, at_least: bool, noise: float) -> bool:
    """Tell whether a figure is worse than another by more than a share of it."""
    return now < before / (1.0 + noise) if at_least else now > before * (1.0 + noise)


def find(measured: Measured, benchmark: str, name: str) -> Row | None:
    """Return the row of a name; None if there is none."""
    return next((row for row in measured.get(benchmark, []) if row.name == name), None)


def read(file: Path) -> Measured:
    """Return what a file holds; nothing if it is not there."""
    if not file.exists():
        return {}
    content = json.loads(file.read_text(encoding="utf-8"))
    return {benchmark: [Row(**row) for row in rows] for benchmark, rows in content.items()}


def write(file: Path, measured: Measured) -> None:
    """Write rows to a file; those of other benchmarks that are there already stay."""
    rows = {name: [asdict(row) for row in found] for name, found in {**read(file), **measured}.items()}
    draft = file.with_name(f"{file.name}.new")
    draft.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    draft.replace(file)
