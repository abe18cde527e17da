"""The verdict in words: which key matters most, and how sure that is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from acoexp.sensitivity.shares import LEVEL, Share, Shares

PHRASES = {
    "gap": "the gap to the optimum",
    "cycles": "the cycles until the optimum was found",
    "found": "whether the optimum was found",
    "lost": "the share of ants that were lost",
}
"""Each outcome within a sentence."""


def verdict(keys: Sequence[str], shares: Mapping[str, Shares | None], where: str) -> str:
    """Return what matters to the first outcome that varies; if nothing is shown to, also to one where it is.

    Args:
        keys: The keys.
        shares: By outcome; None where it has no variance.
        where: The map's name.
    """
    varied = {outcome: found for outcome, found in shares.items() if found is not None}
    if not varied:
        return f"No key matters on {where}: all trials came to the same."
    outcome, found = next(iter(varied.items()))
    seeds = f"The seed alone makes up {percent(found.seeds)}."
    if _shown(found):
        said = "matters most" if _sure(found) else "may matter most"
        return f"{keys[leader(found)]} {said} on {where}: it explains {_explained(outcome, found)}. {seeds}"
    best = found.total[leader(found)]
    of = f"of the variance of {PHRASES[outcome]}"
    none = f"No key is shown to matter on {where}: none explains more than {percent(best)} {of}. {seeds}"
    others = (
        f" But {keys[leader(one)]} explains {_explained(other, one)}."
        for other, one in varied.items()
        if _shown(one) and _sure(one)
    )
    return none + next(others, "")


def _shown(shares: Shares) -> bool:
    """Tell whether the largest share is more than nothing."""
    return shares.total[leader(shares)].low > 0.0


def _sure(shares: Shares) -> bool:
    """Tell whether another draw of points would hardly have another key's share for the largest."""
    return float(shares.first[leader(shares)]) >= LEVEL


def _explained(outcome: str, shares: Shares) -> str:
    best = leader(shares)
    rank = f"{100.0 * shares.first[best]:.0f} % of resamples"
    rank = f"the largest share in {rank}" if _sure(shares) else f"the largest share in only {rank}"
    share, alone = percent(shares.total[best]), percent(shares.alone[best])
    several = f", {alone} whatever the other keys are; it is {rank}" if len(shares.total) > 1 else ""
    return f"{share} of the variance of {PHRASES[outcome]}{several}"


def leader(shares: Shares) -> int:
    """Return the place of the key whose total share is the largest."""
    return int(np.argmax([share.value for share in shares.total]))


def percent(share: Share) -> str:
    """Return a share with its interval, such as ``46 % [38, 55]``."""
    value, low, high = (round(100.0 * number) + 0 for number in share)
    return f"{value} % [{low}, {high}]"
