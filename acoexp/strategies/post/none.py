"""No post-optimiser: a path stays as the ant walked it."""

from __future__ import annotations

from dataclasses import dataclass

from acoexp.strategies.part import Post


@dataclass(frozen=True, kw_only=True)
class NoPost(Post):
    """Leaves paths as they were walked."""

    kernel = None
