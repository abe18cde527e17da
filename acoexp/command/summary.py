"""What a person sees at the end: a trial's features, or a sweep's table, each mean with its spread below."""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

Trial = dict[str, Any]


def finished(folder: Path) -> dict[Path, int]:
    """Return the records of finished trials below a folder, each with the time it was written, in ns."""
    return {file: file.stat().st_mtime_ns for file in folder.rglob("trial.json")}


def print_trial(folder: Path, where: str) -> None:
    """Print what one trial found."""
    trial = json.loads((folder / "trial.json").read_text(encoding="utf-8"))
    console = _console()
    console.print(_table([[trial]], spread=False))
    _warn_of_lost(console, [trial])
    console.print(f"files: {folder}\nrun:   {where}", highlight=False, soft_wrap=True)


def print_sweep(folder: Path, records: Sequence[Path], jobs: int | None, where: str, seconds: float) -> None:
    """Print one row for each cell of a sweep, that is for each configuration apart from the seed."""
    trials = [json.loads(file.read_text(encoding="utf-8")) for file in records]
    cells: dict[str, list[Trial]] = {}
    for trial in sorted(trials, key=_order):
        cells.setdefault(trial["cell"], []).append(trial)
    console = _console()
    if cells:
        console.print(_table(list(cells.values()), spread=True))
    _warn_of_lost(console, trials)
    of_all = "" if jobs is None else f" of {jobs}"
    console.print(
        f"{len(trials)}{of_all} trials finished in {seconds:.1f} s\nfiles: {folder}\nruns:  {where}",
        highlight=False,
        soft_wrap=True,
    )


def print_report(folder: Path, headline: Sequence[Sequence[str]]) -> None:
    """Print a report's short table, and where the report lies."""
    console = _console()
    if headline:
        table = Table(*headline[0], box=None, header_style="bold", pad_edge=False, padding=(0, 1, 0, 0))
        for row in headline[1:]:
            table.add_row(*row)
        console.print(table)
    console.print(f"report: {folder}", highlight=False, soft_wrap=True)


def _order(trial: Trial) -> list[tuple[float, str]]:
    """Return what rows are sorted by: map, algorithm, then every setting, numbers as numbers."""
    values = [trial["map"], trial["algo"], *trial["config"].values(), str(trial["seed"])]
    return [(float(v), "") if re.fullmatch(r"-?[\d.]+(e[+-]?\d+)?", v) else (math.inf, v) for v in values]


def _warn_of_lost(console: Console, trials: Sequence[Trial]) -> None:
    """Say it where ants never arrived: a dash alone does not tell why."""
    never = sum(trial["l1"] is None for trial in trials)
    if never:
        console.print(f"in {never} of {len(trials)} trials no ant ever reached the goal: all were lost on the way")


def _console() -> Console:
    """Return standard output; what is no terminal has no width at which a table would have to be cut."""
    console = Console()
    return console if console.is_terminal else Console(width=1000)


def _table(cells: Sequence[list[Trial]], spread: bool) -> Table:
    table = Table(box=None, header_style="bold", pad_edge=False, padding=(0, 1, 0, 0))
    varied = _varied([cell[0]["config"] for cell in cells])
    headings = ["algo", "map", *varied, "x1", "x2", "x3", "l1", "l2", "optimum", "gap", "lost"]
    if spread:
        headings += ["found", "ms"]
    for heading in headings:
        table.add_column(heading, justify="left" if heading in ("algo", "map") else "right", no_wrap=True)
    for cell in cells:
        table.add_row(*_row(cell, varied, spread))
    return table


def _row(cell: list[Trial], varied: Sequence[str], spread: bool) -> list[str]:
    first, optimum = cell[0], cell[0]["optimum"]
    digits = 1 if spread else 0
    cycles = [_mean((t[key] or None for t in cell), digits) for key in ("x1", "x2", "x3")]
    lengths = [_mean((t[key] for t in cell), 4) for key in ("l1", "l2")]
    gap = _mean((None if t["l1"] is None else 100.0 * (t["l1"] / optimum - 1.0) for t in cell), 2, unit=" %")
    lost = _mean((float(sum(t["lost_ants"])) for t in cell), digits)
    row = [first["algo"], first["map"], *(first["config"].get(key, "") for key in varied)]
    row += [*cycles, *lengths, f"{optimum:.4f}", gap, lost]
    if spread:
        found = sum(t["l1_pair"] == t["optimum_pair"] for t in cell)
        row += [f"{found}/{len(cell)}", _mean((1000.0 * t["seconds"] for t in cell), 1)]
    return row


def _mean(values: Iterable[float | None], digits: int, unit: str = "") -> str:
    """Return the mean of the values that there are and, below it, the sample's standard deviation."""
    there = np.array([value for value in values if value is not None], dtype=float)
    if not there.size:
        return "-"
    mean = f"{there.mean():.{digits}f}{unit}"
    return (
        f"{mean}\n{_plus_minus()}{there.std(ddof=1):.{min(digits, 2)}f}{' ' * len(unit)}"
        if there.size > 1
        else mean
    )


def _plus_minus() -> str:
    try:
        "±".encode(sys.stdout.encoding or "ascii")
    except UnicodeEncodeError:
        return "+-"
    return "±"


def _varied(configs: Sequence[dict[str, str]]) -> list[str]:
    """Return the keys in which cells differ, besides algorithm and map; the parts only where both are alike."""
    keys = sorted({key for config in configs for key in config} - {"algo", "map.name", "seed"})
    if len({(c["algo"], c["map.name"]) for c in configs}) == len(configs):
        return []
    return [key for key in keys if len({config.get(key, "") for config in configs}) > 1]
