"""Addresses without their secrets: what is printed, logged or written goes through :func:`masked`.

A password may hold what no address should, such as ``@`` or ``/``, and an error may repeat pieces of what it took
such an address for. So where the address is known, its secrets are masked wherever they stand; elsewhere, whatever
looks like one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from urllib.parse import unquote

MASK = "***"

_WORDS = "pass|pwd|token|secret|credential|signature|api[_-]?key|access[_-]?key|auth|jwt|odbc_connect"
_KEY = rf"(?:[\w-]*(?:{_WORDS})[\w-]*|sig|sas|pw)"
_END = r"[;,.'\")\]}]*(?:[&\s]|$)"
_QUERY = re.compile(rf"(?P<key>(?:^|[?&;\s]){_KEY}=)(?P<value>[^&\s]*?)(?={_END})", re.IGNORECASE)
"""``?password=...``, and the same among words, as drivers of databases have it."""
_CREDENTIALS = re.compile(r"(?<=://)(?P<value>[^/\s]\S*)(?=@)")
"""All between ``//`` and the last ``@``; an address of a file has nothing there but its path."""
_AUTHORITY = r"^(?!sqlite|file|.*\s\S*://)(?:[A-Za-z][\w+.-]*:/+|//)?([^/].*)@"
"""The credentials of an address, also of one with a slip in its scheme."""
_CUT = re.compile(r"(?<=://)(?P<value>[^/\s]\S*:\S*)(?=\.\.\. \(\d+ characters\))")
"""The beginning of an address of which a message shows no more, and so not the ``@``."""
_SLIP = re.compile(
    r"(?P<before>uri(?:=|: )['\"]?(?:(?!\S*://)|(?=//))/*|\b(?:http|postgres|mysql|mssql|oracle)[\w+]*:/?(?!/))(?P<value>[^/\s'\"]\S*)(?=@)"
)
"""Credentials where the ``//`` before them, or the scheme, was forgotten."""
_SHORTEST = 3
"""Characters from which on a piece of a password is looked for: an error's own words are left alone."""


def masked(text: str, address: str = "") -> str:
    """Return a text without passwords and tokens.

    Args:
        text: What is to be shown, an address or what repeats one.
        address: The address whose secrets are masked also where they stand alone.
    """
    for secret in sorted(set(_secrets(address)), key=len, reverse=True):
        text = re.sub(rf"(?<!\w){re.escape(secret)}(?!\w)", MASK, text)
    text = _CREDENTIALS.sub(MASK, _QUERY.sub(rf"\g<key>{MASK}", text))
    return _SLIP.sub(rf"\g<before>{MASK}", _CUT.sub(MASK, text))


def _secrets(address: str) -> Iterator[str]:
    """Yield an address's secrets: whole, in pieces, and as they are meant where they are percent-encoded."""
    without_query = _QUERY.sub(r"\g<key>", address)
    credentials = re.search(_AUTHORITY, without_query, re.DOTALL)
    values = [found["value"] for found in _QUERY.finditer(address)]
    if credentials is not None and ":" in credentials[1]:
        yield credentials[1]
        values.append(credentials[1].partition(":")[2])
    for value in values:
        for form in {value, unquote(value)}:
            yield from (piece for piece in [form, *re.split(r"[@/:?#&]", form)] if len(piece) >= _SHORTEST)
