"""Texts from elsewhere as a terminal may show them: they can hold anything, and a terminal obeys some of it."""

from __future__ import annotations


def printable(text: str) -> str:
    """Return a text with each sign that cannot be seen, such as a terminal's commands, as its escape ``\\x1b``."""
    return "".join(sign if sign.isprintable() else sign.encode("unicode_escape").decode() for sign in text)


def one_line(text: str) -> str:
    """Return a message of any lines as one; blanks within a line stay, as they may be a name's."""
    return printable(" ".join(filter(None, map(str.strip, text.splitlines()))))
