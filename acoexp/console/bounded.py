"""YAML from anybody: a few lines whose aliases stand for one another can be endless, or larger than any memory."""

from __future__ import annotations

import re
from itertools import accumulate

import yaml

_DEEPEST = 100
"""Brackets that may stand open at once."""


def check_bounded(text: str, most: int) -> None:
    """Refuse a text in YAML that would have too many values with its aliases written out.

    Args:
        text: The text.
        most: Values that it may have, each mapping and list being one as well.

    Raises:
        ValueError: if it has more, or contains itself.
        YAMLError: if it is no YAML.
        RecursionError: if it is too deep.
    """
    # the reader takes time by the square of its depth before it gives up
    if max(accumulate(1 if sign in "[{" else -1 for sign in re.findall(r"[\[\]{}]", text)), default=0) > _DEEPEST:
        raise RecursionError
    sizes: dict[int, int | None] = {}

    def size(node: yaml.Node | None) -> int:
        if node is None or isinstance(node, yaml.ScalarNode):
            return 1
        if id(node) not in sizes:
            sizes[id(node)] = None
            inner = [part for pair in node.value for part in (pair if isinstance(pair, tuple) else (pair,))]
            sizes[id(node)] = 1 + sum(map(size, inner))
        known = sizes[id(node)]
        if known is None or known > most:
            raise ValueError("its aliases make it endless, or too large")
        return known

    size(yaml.compose(text, Loader=yaml.SafeLoader))
