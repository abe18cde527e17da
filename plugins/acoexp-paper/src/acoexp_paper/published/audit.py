"""The audit: what the paper's own tables and equations contradict, recomputed from the CSV files."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from acoexp.grid.moves import path_length
from acoexp_paper.published import tables
from acoexp_paper.published.tables import ALGOS, COLUMNS, ENVIRONMENTS, MISPRINTS, TABLES, TITLES


class Recomputed(NamedTuple):
    """A printed average beside that of the printed rows.

    Attributes:
        table: 1 or 2.
        algo: The preset.
        column: The column.
        printed: The average as printed.
        of_rows: That of the rows as printed.
        of_mended: That of the rows without misprints.
    """

    table: int
    algo: str
    column: str
    printed: float
    of_rows: float
    of_mended: float

    @property
    def differs(self) -> bool:
        """Whether the printed average is not that of its rows, to the digits that are printed."""
        digits = 4 if self.column.startswith("l") else 1
        return abs(self.printed - self.of_rows) > 0.5 * 10.0**-digits + 1e-9


def recomputed() -> list[Recomputed]:
    """Return every average of Tables 1 and 2 as printed and as its rows have it."""
    return [
        Recomputed(table, algo, name, tables.average(table, algo, name), *_means(table, algo, name))
        for table in TABLES
        for algo in ALGOS
        for name in COLUMNS
    ]


def _means(table: int, algo: str, name: str) -> tuple[float, float]:
    return float(tables.column(table, algo, name).mean()), float(tables.mended(table, algo, name).mean())


def impossible_rows() -> Iterator[str]:
    """Yield what cannot be in a printed row: lengths off the lattice, x1, x2, x3 out of order."""
    for table, env in TABLES.items():
        for algo in ALGOS:
            for trial, row in enumerate(tables.rows(table, algo), 1):
                where = f"Table {table}, {TITLES[algo]}, trial {trial}"
                yield from (f"{where}: {problem}." for problem in _problems(row, ENVIRONMENTS[env].optimum))


def _problems(row: dict[str, float], optimum: float) -> Iterator[str]:
    for name in ("l1", "l2"):
        if decompose(row[name]) is None:
            meant = MISPRINTS.get(row[name])
            yield f"{name} = {row[name]:.4f} is the length of no path on the lattice; {meant:.4f} is meant"
    x1, x2, x3 = (int(row[name]) for name in ("x1", "x2", "x3"))
    if not x1 <= x2 <= x3:
        yield f"x1 = {x1}, x2 = {x2}, x3 = {x3}, but x1 <= x2 <= x3 by definition"
    l1, l2 = (MISPRINTS.get(row[name], row[name]) for name in ("l1", "l2"))
    if min(l1, l2) < (printed := round(optimum, 4)):
        yield f"l1 = {l1}, l2 = {l2} is below the optimum, {printed}"
    if l1 == l2 and x2 != x3 and x1 <= x2:
        yield (
            f"l2 = l1, yet x1 = {x1}, x2 = {x2}, x3 = {x3}: the curve left its best length after it was found "
            "twice in a row and came back to it, which is possible but not what the text says of x1, x2, x3"
        )


def decompose(length: float) -> tuple[int, int] | None:
    """Return a printed length as (straight, diagonal) moves of a corner-to-corner path; None if it is none."""
    for diagonal in range(60):
        for straight in range(0, 80, 2):
            if abs(round(path_length(straight, diagonal), 4) - length) < 1e-6:
                return straight, diagonal
    return None


def contradictions() -> list[str]:
    """Return where the text, the tables and each other disagree, with numbers from the CSV files."""
    stuck = int((tables.column(2, "pd", "l2") != 35.0711).sum())
    x1, x2, x3 = (tables.average(2, "pdg", name) for name in ("x1", "x2", "x3"))
    return [
        f"Sect. 5 says that ACO-PD converges to a local optimum five times in Table 2; its rows show {stuck}.",
        f"Table 3 says that ACO-PDG needs {tables.performance('env2', 'pdg', 'n_bar'):g} iterations in "
        f"environment 2; Table 2 gives the same algorithm {x1:g} (x1), {x2:g} (x2) or {x3:g} (x3) "
        "there.",
        "Sect. 5 calls 41.4558 = 16 + 18 √2 \"the optimal path\" of an environment whose optimum is 30.3848 = "
        "12 + 13 √2, after a raw path of 51.1127 = 20 + 22 √2. They are one ant's path before and after the "
        "post-optimiser.",
        "Sect. 5 gives 35.0771 as the best of ACO-PDG in Table 2, where every row has 35.0711.",
        "Sect. 5 says that every algorithm finds the optimum of Table 1, and of Table 2 that standard ACO does so "
        "\"only five times\": x1 is there the first cycle with the run's own best length, l1, which the paper "
        "defines as the optimum's.",
    ]  # fmt: skip


EQUATIONS = {
    "Eq. 3": "The second case must read ρ > ρ0; as printed the cases overlap and leave ρ > ρ0 undefined. Its ρ is "
    "a distance; that of Eq. 18 is the evaporation rate.",
    "Eq. 5": "round((8 θ + π) / (2 π) + 1) is off by half a sector. With the sectors as defined just above it: "
    "j = floor(θ / (π/4) + 1/2) mod 8 + 1.",
    "Eq. 11": "The second terms need x3 - x4 and y3 - y4, as Eq. 12 has them.",
    "Eq. 13": "k_AB = det(x3 - x1, x3 - x4; y3 - y1, y3 - y4) / Δ; as printed it is 1 whatever the segments.",
    "Eq. 14": 'Right but for a stray "=": k_CD = det(x2 - x1, x3 - x1; y2 - y1, y3 - y1) / Δ.',
    "Eq. 15": "Inclusive bounds make any two consecutive segments cross at the cell they share. Only segments "
    "that are not consecutive, and strict inequalities, make sense: two diagonals of one 2 x 2 block.",
    "Eq. 16": "Its bounds mix their indices; it follows from Eq. 15 anyway.",
    "Eq. 17": "Slopes lose the direction of travel, fail for vertical segments, and the second has x and y "
    "exchanged. Meant is that BA and BC enclose 45°, so A and C are neighbours and B can go.",
}
"""The equations that cannot be meant as printed, and what is computed here instead."""
