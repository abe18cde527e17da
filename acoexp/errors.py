"""What can go wrong, as exceptions that a user meets.

Every message names the key or file at fault, what was expected and what came.
"""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from typing import Any

_LONGEST = 200
"""Characters of what came that a message shows."""


class AcoexpError(Exception):
    """Base of all errors that acoexp raises on purpose: one sentence for the user, no traceback needed."""


class SettingsError(AcoexpError, ValueError):
    """A key is unknown, or its value has the wrong type or lies outside its range."""


class MapError(AcoexpError, ValueError):
    """A map cannot be read, or is not one on which a path could be planned."""


class StrategyError(AcoexpError, RuntimeError):
    """A strategy cannot be found, imported or compiled, or broke its contract while it ran."""


class TrackingError(AcoexpError, OSError):
    """The store of results cannot be reached or written."""


class StoreGoneError(TrackingError):
    """The store was there and has been away for longer than one waits for it."""


def shown(value: Any) -> str:
    """Return what came as a message shows it: a text in quotes, and of what is very long its beginning."""
    if isinstance(value, int) and abs(value) >= 10**_LONGEST:
        return f"a number of more than {_LONGEST} digits"  # Python refuses to write thousands of them out
    try:
        text = repr(value)
    except ValueError:  # such a number is somewhere within
        text = f"a {type(value).__name__}"
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}... ({len(text)} characters)"


def did_you_mean(given: Any, known: Iterable[str]) -> str:
    """Return the end of a message that refuses a word: the known one that is most like it, if one is."""
    like = get_close_matches(str(given), list(known), n=1, cutoff=0.8)
    return f"; did you mean {like[0]}?" if like else ""
