"""The section of readings: what changes if what the paper leaves open is read otherwise, over all maps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from acoexp.report.table import Table, interval, number
from acoexp_paper.claims.averages import Average, Fit
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.rereading import Outcome
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.claims.words import COMPATIBLE, CONTRADICTED, DEPENDS, SHOWN, UNDECIDED
from acoexp_paper.page.document import Block, Heading, Numbers, Text
from acoexp_paper.published.tables import TITLES
from acoexp_paper.trials.readings import ENVS, SOURCES
from acoexp_paper.trials.samples import X2_LAST

_SOURCE = (
    "With pheromone on edges, what Eq. 6 calls phi(i), \"the amount of pheromone diffusion source\", can be "
    "several things. By default it is the pheromone of the edge that gets the share, the one along the force, "
    "which is then multiplied by a constant. Sect. 3.2 rather means another: it speaks of \"pheromone phi(i) "
    "of the current grid\", of \"a diffusible pheromone of the current path point\", and of an amount that "
    "goes \"from grid i to j\", so of what lies at the cell where the ant stands and not on the way ahead of "
    "it. Of the readings here, walked_edge (the pheromone of the edge by which the ant came, that of its path) "
    "and sum_in (of all edges into the cell) are nearest to that; with pheromone=cells and walked_edge it is "
    "Sect. 3.4, step 3, to the letter. Whoever rebuilds the algorithm has to choose."
)  # fmt: skip
_ALL = (
    "What the paper leaves open is a key of acoexp. Here each takes another value alone, then some together, "
    "on all maps. Undirected deposit: ants lay pheromone on both ways of an edge. map.moves: the rule for "
    "diagonals, on those maps alone that keep the published optimum under it."
)
_SIGN = {SHOWN: "+", COMPATIBLE: "=", CONTRADICTED: "-", DEPENDS: "~", UNDECIDED: "o"}


def readings(found: Findings) -> list[Block]:
    """Return what the section on other readings of the paper says."""
    if not found.readings:
        return [Text("Left out, as report.reading_trials=0 asks for.")]
    trials = found.experiment.reading_trials
    return [
        Heading("From where pheromone diffuses"),
        Text(_SOURCE),
        Numbers("sources", _sources(found, trials)),
        Heading("All readings"),
        Text(f"{_ALL} {_of_x2(found.averages)}"),
        Numbers("readings", _fits(found, trials)),
        Numbers("reading_claims", _signs(found, trials)),
    ]


def _of_x2(averages: Sequence[Average]) -> str:
    """Say which reading of x2 meets more of its published averages."""
    inside = {name: [row.inside for row in averages if row.printed.column == name] for name in ("x2", X2_LAST)}
    return (
        f"x2 is read as the first cycle that finds l1 twice in a row, which meets {sum(inside['x2'])} of "
        f"{len(inside['x2'])} published averages on the environments' own maps; as the last cycle with l1 where "
        f"l2 differs it meets {sum(inside[X2_LAST])}: the column x2_last of the averages."
    )


def _sources(found: Findings, trials: int) -> Table:
    outcomes = [one for one in found.readings if one.reading in SOURCES]
    note = (
        "The effect over all maps, and its verdict, with each source of the pheromone that diffuses. The "
        f"default's column is that of the claims; the others are of {trials} trials a map. *: the effect "
        "differs from the default's on the same seeds (p < 0.05 after Holm's correction over all readings and "
        "claims), and so does the verdict; without it a verdict may differ by the smaller number of trials alone."
    )
    headings = [
        "claim",
        "map",
        "paper",
        "force_edge (default)",
        *(o.reading.text.partition("=")[2] for o in outcomes),
    ]
    rows = [
        [
            one.claim.kind.text,
            one.claim.map,
            "-" if one.published is None else number(one.published),
            _said(one, changed=False),
            *(_said(o.claims[one.claim.key].judged, one.claim.key in o.changed) for o in outcomes),
        ]
        for one in found.claims
        if "pd" in one.claim.kind.algos and all(one.claim.key in o.claims for o in outcomes)
    ]
    return Table("If pheromone diffuses from another source.", note, headings, rows)


def _said(judged: Judged, changed: bool) -> str:
    return f"{judged.verdict} {interval(*judged.over.mean)}{' *' if changed else ''}"


def _fits(found: Findings, trials: int) -> Table:
    note = (
        "Published averages inside the interval of ten trials' means on a map that is drawn too, of those in "
        f"each block of the tables; {trials} trials per algorithm and map, the defaults as in the averages. "
        "Changed: claims whose verdict and effect are others than under the defaults. The maps were searched "
        "for under the defaults, which favours these for standard ACO."
    )
    blocks = [f"Table {table} {TITLES[algo].removeprefix('ACO-')}" for table, _, algo in found.met]
    maps = {env: len(found.experiment.maps_of(env)) for env in ENVS}
    rows = [_fit_row(found, "the defaults", found.met, maps, "")]
    rows += [_fit_row(found, o.reading.text, o.fit, o.maps, str(len(o.changed))) for o in found.readings]
    headings = ["reading", "maps", *blocks, "all", "changed"]
    return Table("How well each reading meets the published averages.", note, headings, rows)


def _fit_row(found: Findings, text: str, fit: Fit, maps: Mapping[str, int], changed: str) -> list[str]:
    met, of = (sum(column) for column in zip(*fit.values(), strict=True)) if fit else (0, 0)
    counts = ("{}/{}".format(*fit[block]) if block in fit else "-" for block in found.met)
    return [text, " + ".join(map(str, maps.values())), *counts, f"{met}/{of}", changed]


def _signs(found: Findings, trials: int) -> Table:
    numbered = "; ".join(f"{i}: {one.reading.text}" for i, one in enumerate(found.readings, 1))
    note = (
        f"Over all maps that a reading fits, {trials} trials on each. " + ", ".join(f"{s} {w}" for w, s in
        _SIGN.items()) + f"; blank: no map; *: changed, as above. 0: the defaults; {numbered}."
    )  # fmt: skip
    headings = ["claim", "map", "0", *(str(number) for number in range(1, len(found.readings) + 1))]
    rows = [
        [
            one.claim.kind.text,
            one.claim.map,
            _SIGN[one.verdict],
            *(_sign(o, one.claim.key) for o in found.readings),
        ]
        for one in found.claims
        if any(one.claim.key in o.claims for o in found.readings)
    ]
    return Table("Which claims hold under which reading.", note, headings, rows)


def _sign(outcome: Outcome, key: str) -> str:
    if key not in outcome.claims:
        return ""
    return _SIGN[outcome.claims[key].judged.verdict] + ("*" if key in outcome.changed else "")
