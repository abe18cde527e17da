"""What a person sees at the end: a trial's features, or a sweep's table, each mean with its spread below."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

from acoexp.command.results.records import TRIAL, read_record
from acoexp.command.results.rows import Row, rows_of
from acoexp.trial.result import why_lost

_WIDE = 110
"""Characters of a line from which on there is room for what makes a path good to drive."""
_QUALITY = {"turns": ("turns", 1), "clear": ("clearance_least", 2), "detour": ("detour", 3)}
"""Columns of it: each feature, and the digits of its mean."""

_NOT_VARIED = {"algo", "map.name", "seed", "seeds"}


def print_trial(folder: Path, named: Path) -> None:
    """Print what the only trial found, before its pictures are drawn and it is kept.

    Args:
        folder: Where its record lies.
        named: What that is called for a person.
    """
    (row,) = rows_of([read_record(folder / TRIAL)])
    console = _console()
    console.print(_table([row], spread=False, wide=console.width >= _WIDE))
    _warn_of_lost(console, [row])
    console.print(f"files: {named}\npictures follow, then where it is kept", highlight=False, soft_wrap=True)


def print_run(where: str) -> None:
    """Print where the run of one trial is kept."""
    _console().print(f"run:   {where}", highlight=False, soft_wrap=True)


def print_sweep(records: Sequence[Mapping[str, Any]], folder: Path, where: str, ended: str) -> None:
    """Print one row for each configuration of a sweep, whatever its seeds.

    Args:
        records: Of all trials and batches.
        folder: The sweep's folder.
        where: Where the runs are.
        ended: What is said of the sweep's end.
    """
    rows = rows_of(records)
    console = _console()
    if rows:
        console.print(_table(rows, spread=True, wide=console.width >= _WIDE))
    _warn_of_lost(console, rows)
    console.print(f"{ended}\nfiles: {folder}\nruns:  {where}", highlight=False, soft_wrap=True)


def print_report(folder: Path, headline: Sequence[Sequence[str]]) -> None:
    """Print a report's short table, and where the report lies."""
    console = _console()
    if headline:
        table = Table(*headline[0], box=None, header_style="bold", pad_edge=False, padding=(0, 1, 0, 0))
        for row in headline[1:]:
            table.add_row(*row)
        console.print(table)
    console.print(f"report: {folder}", highlight=False, soft_wrap=True)


def _warn_of_lost(console: Console, rows: Sequence[Row]) -> None:
    """Say it where ants never arrived: a dash alone does not tell why."""
    never, trials = sum(row.summary.never_arrived for row in rows), sum(row.summary.trials for row in rows)
    if never:
        console.print(f"in {never} of {trials} trials no ant ever reached the goal: all were lost on the way")
    for row in rows:
        if not math.isnan(row.lost_after):
            advice = "; algo=nav steps back from dead ends"
            if row.config.get("dead_end") == "step_back":
                advice = (
                    "; max_steps=null lets them go on" if row.config.get("max_steps", "None") != "None" else ""
                )
            console.print(f"{row.algo} on {row.map}: {why_lost(row.lost_after, row.optimum)}{advice}")


def _console() -> Console:
    """Return standard output; what is no terminal has no width at which a table would have to be cut.

    Names of maps, folders and configurations are a person's: rich is to read no markup and no emoji into them.
    """
    plain = partial(Console, markup=False, emoji=False)
    return plain() if plain().is_terminal else plain(width=1000)


def _table(rows: Sequence[Row], spread: bool, wide: bool) -> Table:
    table = Table(box=None, header_style="bold", pad_edge=False, padding=(0, 1, 0, 0))
    varied = _varied(rows)
    headings = ["algo", "map", *varied, "x1", "x2", "x3", "l1", "l2", "optimum", "gap", "lost"]
    headings += _QUALITY if wide else ()
    if spread:
        headings += ["found", "ms"]
    for heading in headings:
        _add_column(table, heading, is_named=heading == "map" or heading in varied)
    for row in rows:
        table.add_row(*_texts(row, varied, spread, wide))
    return table


def _add_column(table: Table, heading: str, is_named: bool) -> None:
    """Add a column; where a terminal is too narrow, long names fold rather than push figures out."""
    left = heading in ("algo", "map")
    table.add_column(heading, justify="left" if left else "right", no_wrap=not is_named, overflow="fold")


def _texts(row: Row, varied: Sequence[str], spread: bool, wide: bool) -> list[str]:
    means, deviations = row.summary.means, row.summary.deviations

    def shown(name: str, digits: int) -> str:
        return _mean(means.get(name, math.nan), deviations.get(name, math.nan), digits)

    digits = 1 if spread else 0
    percent = 100.0 / row.optimum
    gap = _mean(percent * (means["l1"] - row.optimum), percent * deviations["l1"], 2, unit=" %")
    texts = [row.algo, row.map, *(row.config.get(key, "") for key in varied)]
    texts += [*(shown(n, digits) for n in ("x1", "x2", "x3")), *(shown(n, 4) for n in ("l1", "l2"))]
    texts += [f"{row.optimum:.4f}", gap, shown("lost_ants", digits)]
    texts += [shown(*column) for column in _QUALITY.values()] if wide else []
    if spread:
        texts += [f"{row.found}/{row.summary.trials}", _mean(row.milliseconds, math.nan, 1)]
    return texts


def _mean(mean: float, deviation: float, digits: int, unit: str = "") -> str:
    """Return a mean and, below it, the sample's standard deviation, where there are any."""
    if math.isnan(mean):
        return "-"
    text = f"{round(mean, 9) + 0.0:.{digits}f}{unit}"  # no minus before a zero
    if math.isnan(deviation):
        return text
    return f"{text}\n{_plus_minus()}{deviation:.{min(digits, 2)}f}{' ' * len(unit)}"


def _plus_minus() -> str:
    try:
        "±".encode(sys.stdout.encoding or "ascii")
    except UnicodeEncodeError:
        return "+-"
    return "±"


def _varied(rows: Sequence[Row]) -> list[str]:
    """Return the keys in which rows differ, besides algorithm and map; the parts only where both are alike."""
    if len({(row.algo, row.map) for row in rows}) == len(rows):
        return []
    configs = [row.config for row in rows]
    keys = sorted({key for config in configs for key in config} - _NOT_VARIED)
    return [key for key in keys if len({config.get(key, "") for config in configs}) > 1]
