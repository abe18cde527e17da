"""The section of readings: how many averages each reading of the paper meets, and which claims hold under it."""

from __future__ import annotations

from collections.abc import Sequence

from acoexp.report.table import Table
from acoexp_paper.claims.averages import Average
from acoexp_paper.claims.findings import Findings, Outcome
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.page.document import Block, Numbers, Text
from acoexp_paper.published.tables import TITLES
from acoexp_paper.trials.samples import X2_LAST

_INTRO = (
    "What the paper leaves open is a key of acoexp. Here each takes another value alone, and a few that "
    "belong together do so together. pheromone=cells with diffusion.source=walked_edge is Sect. 3.4, step 3, "
    "to the letter."
)
_SIGN = {1: "+", 0: "o", -1: "-"}


def readings(found: Findings) -> list[Block]:
    """Return what the section on other readings of the paper says."""
    if not found.readings:
        return [Text("Left out, as report.ensemble_trials=0 asks for.")]
    return [
        Text(_INTRO),
        Text(_of_x2(found.averages)),
        Numbers("readings", _fit(found.readings, found.experiment.ensemble_trials)),
        Numbers("reading_claims", _claims(found.readings, [judged.claim for judged in found.claims])),
    ]


def _of_x2(averages: Sequence[Average]) -> str:
    """Say which reading of x2 meets more of its published averages."""
    inside = {name: [row.inside for row in averages if row.printed.column == name] for name in ("x2", X2_LAST)}
    return (
        f"x2 is read as the first cycle that finds l1 twice in a row, which meets {sum(inside['x2'])} of "
        f"{len(inside['x2'])} published averages; as the last cycle with l1 where l2 differs it meets "
        f"{sum(inside[X2_LAST])}. Nothing has to be run for that: it is the column x2_last of the averages."
    )


def _fit(outcomes: Sequence[Outcome], trials: int) -> Table:
    note = (
        "Published averages inside the interval of ten trials' means, of those in each block of the tables; "
        f"{trials} trials per algorithm and map. The maps were searched for under the defaults, which favours "
        "these for standard ACO."
    )
    blocks = [f"Table {table} {TITLES[algo].removeprefix('ACO-')}" for table, _, algo in outcomes[0].fit]
    rows = [
        [o.reading.text, *(f"{i}/{n}" for i, n in o.fit.values()), f"{o.inside}/{o.averages}"] for o in outcomes
    ]
    return Table("How well each reading meets the published averages.", note, ["reading", *blocks, "all"], rows)


def _claims(outcomes: Sequence[Outcome], claims: Sequence[Claim]) -> Table:
    numbered = "; ".join(f"{i}: {outcome.reading.text}" for i, outcome in enumerate(outcomes, 1))
    note = (
        "On the environments' maps. +: holds; o: does not, or was not shown; -: the opposite is shown. "
        f"{numbered}."
    )
    headings = ["claim", "map", *(str(number) for number in range(1, len(outcomes) + 1)), "holds under"]
    rows = [
        _row(claim, [o.says[claim.key] for o in outcomes]) for claim in claims if claim.key in outcomes[0].says
    ]
    return Table("Which claims hold under which reading.", note, headings, rows)


def _row(claim: Claim, says: Sequence[int]) -> list[str]:
    return [claim.text, claim.map, *(_SIGN[sign] for sign in says), f"{says.count(1)} of {len(says)}"]
