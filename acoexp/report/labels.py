"""Names in pictures: a person's, so matplotlib is to read nothing into them and to say nothing of their signs."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager


def as_it_is(name: str) -> str:
    """Return a name as matplotlib draws it as it is: what stands between two dollars would be mathematics."""
    return name.replace("$", r"\$")


@contextmanager
def any_signs() -> Iterator[None]:
    """Let figures be saved with signs that the font has not: they are drawn as boxes, without a warning."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", r"Glyph \d+", UserWarning)
        yield
