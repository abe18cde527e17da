"""What the paper printed: its tables, row by row, from the CSV files beside this module."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from functools import cache
from importlib.resources import files
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.moves import path_length

TABLES = {1: "fig13", 2: "env2"}
"""The tables with ten rows for each algorithm, and the environment of each."""

ALGOS = ("aco", "pd", "pdg")
"""The presets that stand for the algorithms of Tables 1 and 2."""

COLUMNS = ("x1", "l1", "x2", "l2", "x3")
"""The columns of Tables 1 and 2, in the paper's order."""

TITLES = {"aco": "Standard ACO", "pd": "ACO-PD", "pdg": "ACO-PDG", "pf": "ACO-PF"}
"""What the paper calls the presets."""

NAMES = {**TITLES, "aco": "standard ACO"}
"""The same within a sentence."""

TRIALS = 10
"""Trials behind each of the paper's averages."""

MISPRINTS = {35.0771: 35.0711, 38.8285: 38.8284}
"""Lengths that no path on a lattice has, and the ones that are meant."""


class Performance(NamedTuple):
    """What Table 3 is about.

    Attributes:
        environments: Its environments.
        algos: Its algorithms.
        columns: Trials that found the optimum, mean l2, mean x1 of those that found it.
    """

    environments: tuple[str, ...] = ("env1", "env2")
    algos: tuple[str, ...] = ("pf", "pdg")
    columns: tuple[str, ...] = ("n_c", "l_bar", "n_bar")


TABLE_3 = Performance()


class Environment(NamedTuple):
    """One of the paper's environments.

    Attributes:
        title: What the paper calls it.
        algos: The algorithms that the paper ran on it.
        optimum_pair: The published optimum as (straight, diagonal) moves.
        only_optimum: Whether nothing else is known of its map.
        shows_pheromone: Whether the paper shows where pheromone lies on its map.
    """

    title: str
    algos: tuple[str, ...]
    optimum_pair: tuple[int, int]
    only_optimum: bool = False
    shows_pheromone: bool = False

    @property
    def optimum(self) -> float:
        """The published optimum, in cells."""
        return path_length(*self.optimum_pair)


ENVIRONMENTS = {
    "fig13": Environment("the environment of Fig. 13", ("aco", "pd", "pdg"), (12, 13), shows_pheromone=True),
    "env1": Environment("environment 1 of Table 3", ("pdg", "pf"), (18, 10), only_optimum=True),
    "env2": Environment("environment 2 (Fig. 17)", ("aco", "pd", "pdg", "pf"), (28, 5)),
}


def rows(table: int, algo: str) -> list[dict[str, float]]:
    """Return the ten printed rows of an algorithm in Table 1 or 2, misprints included."""
    lines = [line for line in _read(f"table{table}") if line["algorithm"] == algo]
    return [{name: float(line[name]) for name in COLUMNS} for line in lines]


def column(table: int, algo: str, name: str) -> NDArray[np.float64]:
    """Return one printed column, float64[10]."""
    return np.array([row[name] for row in rows(table, algo)])


def mended(table: int, algo: str, name: str) -> NDArray[np.float64]:
    """Return one column without its misprints, float64[10]."""
    return np.array([MISPRINTS.get(value, value) for value in column(table, algo, name).tolist()])


def average(table: int, algo: str, name: str) -> float:
    """Return the average that Table 1 or 2 prints below a column."""
    (line,) = (n for n in _read("averages") if (int(n["table"]), n["algorithm"]) == (table, algo))
    return float(line[name])


def performance(env: str, algo: str, name: str) -> float:
    """Return a number of Table 3."""
    (line,) = (n for n in _read("table3") if (n["environment"], n["algorithm"]) == (env, algo))
    return float(line[name])


@cache
def _read(name: str) -> Sequence[dict[str, str]]:
    text = files("acoexp_paper.published").joinpath("data", f"{name}.csv").read_text(encoding="utf-8")
    return tuple(csv.DictReader(text.splitlines()))
