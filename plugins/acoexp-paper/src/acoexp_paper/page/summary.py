"""The summary: what reproduces and what does not, in words and numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from acoexp.report.table import interval
from acoexp_paper.claims.averages import Average
from acoexp_paper.claims.findings import Findings, Outcome
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.statements import CountIs, MeanIs
from acoexp_paper.claims.verdicts import DEPENDS, FAILS, HOLDS, OPPOSITE, VERDICTS, Judged
from acoexp_paper.page.document import Block, Bullets, Heading, Text
from acoexp_paper.published.tables import TITLES
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.readings import DEFAULT
from acoexp_paper.trials.samples import X2_LAST

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
        Text(f"Of {len(found.claims)} claims of the paper, {_counted(found.claims)}. {_averages(found.averages)}")
    ]
    for verdict in VERDICTS:
        blocks += _of_verdict(found.claims, verdict)
    if found.readings:
        claims = [judged.claim for judged in found.claims]
        blocks += [Heading("Other readings of the paper"), Text(_readings(found.readings, claims))]
    return [*blocks, Heading("What this rests on"), Text(_caveat(found.experiment))]


def _counted(claims: Sequence[Judged]) -> str:
    """Say how many claims have each verdict, those that none has left out."""
    count = Counter(judged.verdict for judged in claims)
    said = [f"{count[v]} {(_SINGULAR if count[v] == 1 else _PLURAL)[v]}" for v in VERDICTS if count[v]]
    return " and ".join([", ".join(said[:-1]), said[-1]] if len(said) > 1 else said)


def _averages(averages: Sequence[Average]) -> str:
    rows = [row for row in averages if row.printed.column != X2_LAST]
    of_algo = {title: [row for row in rows if row.printed.algorithm == algo] for algo, title in TITLES.items()}
    parts = (f"{title} {sum(r.inside for r in part)} of {len(part)}" for title, part in of_algo.items())
    return (
        f"Of {len(rows)} published averages, {sum(row.inside for row in rows)} lie where the mean of ten of our "
        f"trials falls in 95 % of cases ({', '.join(parts)})."
    )


def _of_verdict(claims: Sequence[Judged], verdict: str) -> list[Block]:
    judged = [j for j in claims if j.verdict == verdict]
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


def _readings(outcomes: Sequence[Outcome], claims: Sequence[Claim]) -> str:
    scores = {outcome.reading.text: outcome.inside for outcome in outcomes}
    best = max(scores.values())
    names = " and ".join(text for text, score in scores.items() if score == best)
    return (
        f"Of {len(scores)} readings of what the paper leaves open, the defaults meet "
        f"{scores[DEFAULT.text]} of {outcomes[0].averages} published averages on fig13 and env2, and the best, "
        f"{names}, {best}. {_comparisons(outcomes, claims)}"
    )


def _comparisons(outcomes: Sequence[Outcome], claims: Sequence[Claim]) -> str:
    keys = [claim.key for claim in claims if claim.kind.compares and claim.key in outcomes[0].says]
    always = sum(all(outcome.says[key] == 1 for outcome in outcomes) for key in keys)
    never = sum(all(outcome.says[key] != 1 for outcome in outcomes) for key in keys)
    return (
        f"Of {len(keys)} comparisons of algorithms there, {always} come out as published under every reading, "
        f"{never} under none, {len(keys) - always - never} under some."
    )


def _caveat(experiment: Experiment) -> str:
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
