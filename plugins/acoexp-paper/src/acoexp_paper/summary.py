"""The summary: what reproduces and what does not, in words and numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from acoexp.report.tables import interval
from acoexp_paper.averages import X2_LAST
from acoexp_paper.claims import CLAIMS
from acoexp_paper.document import Block, Bullets, Heading, Text
from acoexp_paper.published import TITLES
from acoexp_paper.readings import DEFAULT
from acoexp_paper.statements import CountIs, MeanIs
from acoexp_paper.verdicts import DEPENDS, FAILS, HOLDS, OPPOSITE, VERDICTS, Judged

if TYPE_CHECKING:
    from acoexp_paper.sections import Findings

_PLURAL = {
    HOLDS: "hold",
    FAILS: "do not hold",
    OPPOSITE: "are turned into their opposite",
    DEPENDS: "depend on the map",
}
_SINGULAR = {
    HOLDS: "holds",
    FAILS: "does not hold",
    OPPOSITE: "is turned into its opposite",
    DEPENDS: "depends on the map",
}
_HEADING = {
    HOLDS: "What reproduces",
    FAILS: "What does not hold, or was not shown",
    OPPOSITE: "Where the simulation shows the opposite of the paper",
    DEPENDS: "What depends on the map",
}
_NUMBERS = {
    HOLDS: "Published numbers that ten of our trials may well have on most maps",
    FAILS: "Published numbers that ten of our trials would hardly have on most maps",
    DEPENDS: "Published numbers that they may have on some maps and not on others",
}


def summary(found: Findings) -> list[Block]:
    """Return the summary."""
    blocks: list[Block] = [
        Text(f"Of {len(CLAIMS)} claims of the paper, {_counted(found.claims)}. {_averages(found)}")
    ]
    for verdict in VERDICTS:
        blocks += _of_verdict(found, verdict)
    if found.readings:
        blocks += [Heading("Other readings of the paper"), Text(_readings(found))]
    return [*blocks, Heading("What this rests on"), Text(_caveat(found))]


def _counted(claims: Sequence[Judged]) -> str:
    """Say how many claims have each verdict, those that none has left out."""
    count = Counter(judged.verdict for judged in claims)
    said = [f"{count[v]} {(_SINGULAR if count[v] == 1 else _PLURAL)[v]}" for v in VERDICTS if count[v]]
    return " and ".join([", ".join(said[:-1]), said[-1]] if len(said) > 1 else said)


def _averages(found: Findings) -> str:
    rows = [row for row in found.averages if row.column != X2_LAST]
    of_algo = {title: [row for row in rows if row.algorithm == algo] for algo, title in TITLES.items()}
    parts = (f"{title} {sum(r.inside for r in part)} of {len(part)}" for title, part in of_algo.items())
    return (
        f"Of {len(rows)} published averages, {sum(row.inside for row in rows)} lie where the mean of ten of our "
        f"trials falls in 95 % of cases ({', '.join(parts)})."
    )


def _of_verdict(found: Findings, verdict: str) -> list[Block]:
    judged = [j for j in found.claims if j.verdict == verdict]
    alike: dict[str, list[Judged]] = {}
    for j in judged:
        if not isinstance(j.claim.kind, MeanIs | CountIs):
            alike.setdefault(_text(j), []).append(j)
    items = [f"{text}: {'; '.join(map(_result, group))}." for text, group in alike.items()]
    numbers = [f"{_text(j)} ({_result(j)})" for j in judged if isinstance(j.claim.kind, MeanIs | CountIs)]
    if numbers:
        items.append(f"{_NUMBERS[verdict]}: {'; '.join(numbers)}.")
    return [Heading(_HEADING[verdict]), Bullets(items)] if items else []


def _text(judged: Judged) -> str:
    text = judged.claim.kind.text
    return text[0].upper() + text[1:] + (" *" if judged.claim.fitted else "")


def _result(judged: Judged) -> str:
    """Say what was found on a claim's map, and on how many others it is the same."""
    says, effect = judged.says, judged.finding.effect
    text = f"{judged.claim.map} {judged.finding.measure} {interval(*effect)}"
    if not says:
        return text
    against = f", {says.count(-1)} show the opposite" if -1 in says else ""
    return f"{text}, {says.count(1)} of {len(says)} further maps support it{against}"


def _readings(found: Findings) -> str:
    scores = {
        outcome.reading.text: sum(inside for inside, _ in outcome.fit.values()) for outcome in found.readings
    }
    total = sum(of for _, of in found.readings[0].fit.values())
    best = max(scores.values())
    names = " and ".join(text for text, score in scores.items() if score == best)
    keys = [claim.key for claim in CLAIMS if claim.kind.compares and claim.key in found.readings[0].says]
    always = sum(all(outcome.says[key] == 1 for outcome in found.readings) for key in keys)
    never = sum(all(outcome.says[key] != 1 for outcome in found.readings) for key in keys)
    return (
        f"Of {len(scores)} readings of what the paper leaves open, the defaults meet "
        f"{scores[DEFAULT.text]} of {total} published averages on fig13 and env2, and the best, {names}, {best}. "
        f"Of {len(keys)} comparisons of algorithms there, {always} come out as published under every reading, "
        f"{never} under none, {len(keys) - always - never} under some."
    )


def _caveat(found: Findings) -> str:
    experiment = found.experiment
    rebuilt = [env for env in experiment.maps if env not in experiment.given]
    maps = (
        f"The paper's figures are lost, so {', '.join(rebuilt)} are reconstructions: maps with the published "
        "optimum, found by a search that looked at the rows of standard ACO alone (*: a number that it looked "
        "at). "
        if rebuilt
        else ""
    )
    return maps + (
        "What the maps say of ACO-PD, ACO-PDG and ACO-PF is a prediction. ACO-PF is itself a reconstruction, as "
        "its formulas are in no public source. No constant was chosen to make a claim come out."
    )
