"""The summary: whether the paper holds, in ten lines, and its comparisons of algorithms in one small table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import chain

import numpy as np

from acoexp.compare.statistics import Values
from acoexp.report.table import Table, number
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.likelihood import of_themselves
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.claims.words import COMPATIBLE, DEPENDS, UNDECIDED, VERDICTS
from acoexp_paper.page.document import Block, Bullets, Numbers, Text
from acoexp_paper.published.tables import ENVIRONMENTS, NAMES, TITLES
from acoexp_paper.trials.readings import SOURCES
from acoexp_paper.trials.samples import X2_LAST

_SAID = {
    DEPENDS: ("depends on the map", "depend on the map"),
    UNDECIDED: ("stays undecided", "stay undecided"),
}
"""What is said of one claim, and of several, where it is not that they are what the word says."""

_PREDICTION = (
    "What the maps say of ACO-PD, ACO-PDG and ACO-PF is a prediction; ACO-PF is itself a reconstruction, as its "
    "formulas are in no public source. No constant was chosen to make a claim come out."
)
_TABLE = (
    "The verdict, the effect over all maps, and in brackets that of the paper's own ten trials. A12 is the "
    "probability that the first does better, 0.5 for none; where something happens more often it is the "
    "difference of the shares of trials, 0 for none. x1, x2, x3: Fig. 15. Intervals, tests and printed numbers: "
    "The claims."
)
_ADDS = {
    ("pd", "aco"): "what diffusion adds",
    ("pdg", "pd"): "what the geometric optimisation adds",
    ("pdg", "aco"): "both together",
    ("pdg", "pf"): "the rival of Table 3",
}


def summary(found: Findings) -> list[Block]:
    """Return the summary."""
    lines = [*_fit(found), *_compared(found.counted), _printed(found)]
    lines += [_sources(found)] if found.readings else []
    return [
        Text(
            f"Does the paper hold? Of {len(found.counted)} claims that the maps were not fitted to, "
            f"{counted(found.counted)}."
        ),
        Bullets(lines),
        Numbers("verdicts", _table(found.counted)),
        Bullets([_averages(found), _PREDICTION]),
    ]


def counted(claims: Sequence[Judged]) -> str:
    """Say how many claims have each verdict, those that none has left out."""
    count = Counter(judged.verdict for judged in claims)
    said = [f"{count[v]} {_words(v, count[v])}" for v in VERDICTS if count[v]]
    return " and ".join([", ".join(said[:-1]), said[-1]] if len(said) > 1 else said)


def _words(verdict: str, count: int) -> str:
    one, many = _SAID.get(verdict, (f"is {verdict}", f"are {verdict}"))
    return one if count == 1 else many


def _fit(found: Findings) -> list[str]:
    """Say how well the maps meet what they were fitted to."""
    known = {env: scores for env, scores in found.scores.items() if not np.isnan(scores).any()}
    known = {env: scores for env, scores in known.items() if not ENVIRONMENTS[env].only_optimum}
    if not known:
        return []
    said = "; ".join(
        f"{env} {scores[0]:.1f} ({_further(scores)}the rows themselves {of_themselves(env):.1f})"
        for env, scores in known.items()
    )
    fitted = [judged for judged in found.claims if judged.claim.fitted]
    met = sum(judged.verdict == COMPATIBLE for judged in fitted)
    return [
        "The paper's figures are not available to us, so the maps are reconstructions, fitted to standard "
        f"ACO's rows alone. Log-likelihood of those rows: {said}. Of {len(fitted)} claims about them, {met} "
        f"{'is' if met == 1 else 'are'} compatible: what follows is no better than that fit."
    ]


def _further(scores: Values) -> str:
    further = scores[1:]
    return f"its {further.size} further maps {further.min():.1f} to {further.max():.1f}, " if further.size else ""


def _pairs(claims: Sequence[Judged]) -> dict[tuple[str, ...], list[Judged]]:
    """Return the comparisons by their two algorithms."""
    pairs: dict[tuple[str, ...], list[Judged]] = {}
    for judged in claims:
        if judged.claim.kind.compares:
            pairs.setdefault(judged.claim.kind.algos, []).append(judged)
    return pairs


def _compared(claims: Sequence[Judged]) -> list[str]:
    """Say of each two algorithms what came of their comparisons."""
    return [
        f"{TITLES[a]} against {NAMES[b]} ({_ADDS[a, b]}): of {len(group)} comparisons, {counted(group)}."
        for (a, b), group in _pairs(claims).items()
    ]


def _printed(found: Findings) -> str:
    printed = [judged for judged in found.counted if not judged.claim.kind.compares]
    return f"Of {len(printed)} printed means and counts, {counted(printed)}."


def _averages(found: Findings) -> str:
    rows = [row for row in found.averages if row.printed.column != X2_LAST and not row.printed.fitted]
    of_algo = {title: [row for row in rows if row.printed.algorithm == algo] for algo, title in TITLES.items()}
    parts = (f"{title} {sum(row.inside for row in part)} of {len(part)}" for title, part in of_algo.items())
    over_maps = sum(bool(row.inside_over_maps) for row in rows)
    drawn = f"; where the map is drawn from ours, {over_maps}" if rows[0].over_maps is not None else ""
    return (
        f"Of {len(rows)} published averages that the maps were not fitted to, {sum(row.inside for row in rows)} "
        f"lie where the mean of ten of our trials falls in 95 % of cases ({', '.join(parts)}){drawn}."
    )


def _sources(found: Findings) -> str:
    """Say what the most influential decision changes."""
    sources = [one for one in found.readings if one.reading in SOURCES]
    others = [one for one in found.readings if one.reading not in SOURCES]
    keys = {key for one in sources for key in one.changed}
    most = max(others, key=lambda one: len(one.changed), default=None)
    other = (
        f" Of the other readings, {most.reading.text} changes most verdicts, {len(most.changed)}."
        if most and most.changed
        else " No other reading changes any."
    )
    names = ", ".join(f"{one.reading.text.partition('=')[2]} {len(one.changed)}" for one in sources)
    return (
        "The text leaves open from where pheromone diffuses, and rather speaks against our default: another "
        f"source changes {len(keys)} verdicts of {len(found.readings[0].claims)} beyond chance ({names}).{other}"
        if sources
        else f"Other readings of what the paper leaves open were tried.{other}"
    )


def _table(claims: Sequence[Judged]) -> Table:
    """Return the comparisons, those of two algorithms together, with a column for each environment."""
    envs = list(dict.fromkeys(judged.claim.map for judged in claims if judged.claim.kind.compares))
    rows: dict[str, dict[str, Judged]] = {}
    for judged in chain.from_iterable(_pairs(claims).values()):
        rows.setdefault(judged.claim.kind.text, {})[judged.claim.map] = judged
    return Table(
        "What the paper says of two algorithms.",
        _TABLE,
        ["claim", *envs],
        [[text, *(_cell(of_env.get(env)) for env in envs)] for text, of_env in rows.items()],
    )


def _cell(judged: Judged | None) -> str:
    if judged is None:
        return ""
    published = "" if judged.published is None else f" ({number(judged.published)})"
    return f"{judged.verdict} {number(judged.over.mean.value)}{published}"
