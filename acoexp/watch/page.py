"""The page: one HTML file with the recordings, a style and a script, which needs no other and asks nobody."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any

from acoexp.errors import SettingsError
from acoexp.watch.packing import Packed, packed_map

LARGEST = 15 * 2**20
"""Bytes that a page may have: it is opened at once, and can be sent by mail."""

_SCRIPTS = ("unpack", "colours", "chart", "heat", "ways", "board", "player", "main")
"""The parts of the script, in their order."""

_FRAME_HEIGHT = 760
"""Pixels of the page in a notebook."""


def page_of(colonies: Sequence[Packed]) -> str:
    """Return the page of some packed recordings of trials on one map.

    Raises:
        SettingsError: if it would be larger than ``LARGEST`` bytes.
    """
    grid, cycles = colonies[0].grid, max(one.cycles for one in colonies)
    names = " and ".join(one.colony["name"] for one in colonies)
    content = {"map": packed_map(colonies), "colonies": [one.colony for one in colonies]}
    # nothing in a script ends it but this sign
    data = json.dumps(content, allow_nan=False, separators=(",", ":")).replace("<", r"\u003c")
    page = _filled(
        _asset("page.html"),
        title=escape(f"{names} on {grid.name}"),
        style=_asset("page.css"),
        script="\n".join(_asset(f"{name}.js") for name in _SCRIPTS),
        data=data,
    )
    if len(page) > LARGEST:
        raise SettingsError(
            f"iterations: expected fewer, or fewer cells side by side, for a page of at most {LARGEST // 2**20} "
            f"MB; got {len(page) / 2**20:.1f} MB for {cycles} cycles on a map of {grid.obstacles.size} cells"
        )
    return page


def data_of(page: str) -> dict[str, Any]:
    """Return the data that a page has."""
    data = page.partition('<script type="application/json" id="data">')[2].partition("</script>")[0]
    found: dict[str, Any] = json.loads(data)
    return found


def framed(page: str) -> str:
    """Return a page as a notebook shows it: in a frame of its own, which can reach nothing around it."""
    return (
        f'<iframe title="acoexp" sandbox="allow-scripts" srcdoc="{escape(page)}" '
        f'style="width: 100%; height: {_FRAME_HEIGHT}px; border: 0"></iframe>'
    )


def _filled(template: str, **texts: str) -> str:
    """Put texts in the places that have their names in two braces; in the texts nothing is replaced."""
    return re.sub(r"\{\{(\w+)\}\}", lambda place: texts[place[1]], template)


@cache
def _asset(name: str) -> str:
    return (files("acoexp.watch") / "page" / name).read_text(encoding="utf-8")
