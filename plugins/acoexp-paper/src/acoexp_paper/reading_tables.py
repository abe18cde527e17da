"""What each reading of the paper leads to: how many averages it meets, and which claims hold under it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from acoexp.report.tables import Table
from acoexp_paper.averages import X2_LAST
from acoexp_paper.claims import CLAIMS
from acoexp_paper.document import Block, Numbers, Text
from acoexp_paper.published import TITLES

if TYPE_CHECKING:
    from acoexp_paper.sections import Findings


def interpretations(found: Findings) -> list[Block]:
    """Return what the section on other readings of the paper says."""
    if not found.readings:
        return [Text("Left out, as report.ensemble_trials=0 asks for.")]
    blocks = [(t, env, a) for t, env, a in found.readings[0].fit]
    total = sum(of for _, of in found.readings[0].fit.values())
    fit = Table(
        "How well each reading meets the published averages.",
        f"Published averages inside the interval of ten trials' means, of those in each block of the tables; "
        f"{found.experiment.ensemble_trials} trials per cell. The maps were searched for under the defaults, "
        "which favours these for standard ACO.",
        ["reading", *(f"Table {t} {TITLES[a].removeprefix('ACO-')}" for t, _, a in blocks), "all"],
        [
            [
                o.reading.text,
                *(f"{i}/{n}" for i, n in o.fit.values()),
                f"{sum(i for i, _ in o.fit.values())}/{total}",
            ]
            for o in found.readings
        ],
    )
    keys = list(found.readings[0].says)
    texts = {claim.key: claim for claim in CLAIMS}
    headings = ["claim", "map", *(str(number) for number in range(1, len(found.readings) + 1)), "holds under"]
    rows = [
        [
            texts[key].text,
            texts[key].map,
            *(_SIGN[outcome.says[key]] for outcome in found.readings),
            f"{sum(outcome.says[key] == 1 for outcome in found.readings)} of {len(found.readings)}",
        ]
        for key in keys
    ]
    numbered = "; ".join(f"{i}: {outcome.reading.text}" for i, outcome in enumerate(found.readings, 1))
    matrix = Table(
        "Which claims hold under which reading.",
        "On the environments' maps. +: holds; o: does not, or was not shown; -: the opposite is shown. "
        f"{numbered}.",
        headings,
        rows,
    )
    intro = (
        "What the paper leaves open is a key of acoexp. Here each takes another value alone, and a few that "
        "belong together do so together. pheromone=cells with diffusion.source=walked_edge is Sect. 3.4, step 3, "
        "to the letter."
    )
    return [Text(intro), Text(_readings_of_x2(found)), Numbers("readings", fit), Numbers("reading_claims", matrix)]


def _readings_of_x2(found: Findings) -> str:
    """Say which reading of x2 meets more of its published averages."""
    inside = {name: [row.inside for row in found.averages if row.column == name] for name in ("x2", X2_LAST)}
    return (
        f"x2 is read as the first cycle that finds l1 twice in a row, which meets {sum(inside['x2'])} of "
        f"{len(inside['x2'])} published averages; as the last cycle with l1 where l2 differs it meets "
        f"{sum(inside[X2_LAST])}. Nothing has to be run for that: it is the column x2_last of the averages."
    )


_SIGN = {1: "+", 0: "o", -1: "-"}
