"""Maps written as texts, such as ``rooms map.size=[40,40]#0-19`` or ``movingai:arena.map.scen#0-49``."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path, PurePath
from typing import Any, NamedTuple

from acoexp.compare.overrides import nested
from acoexp.console.plain import printable
from acoexp.errors import AcoexpError, SettingsError, shown
from acoexp.grid.grid import Grid
from acoexp.maps.movingai import parse_instance
from acoexp.maps.reading import read_text
from acoexp.registry.entries import part_names
from acoexp.registry.load_map import load_map
from acoexp.registry.parts import find_part
from acoexp.trial.seeds import Seeds, parse_seeds

MOST_MAPS = 1000
"""Maps that one report may have."""

_NUMBERS = re.compile(r"#([\d,-]+)\Z")
_OVERRIDE = re.compile(r"\s+(?=[\w.]+=)")
_BY_ENDING = {
    **dict.fromkeys((".map", ".scen"), "movingai"),
    **dict.fromkeys((".yaml", ".yml"), "ros"),
    **dict.fromkeys((".png", ".bmp", ".jpg", ".jpeg", ".tga", ".pgm"), "image"),
}
"""Sources of files that are given without one; any other file is one of ``file``."""


@dataclass(frozen=True, kw_only=True)
class MapText:
    """One map, as a text says it: a source and its parameters.

    Attributes:
        text: The text, of a range its part for this map alone.
        source: Name of the source.
        parameters: Its parameters.
    """

    text: str
    source: str
    parameters: dict[str, Any]

    @cached_property
    def named(self) -> str:
        """What messages call it."""
        return f"report.maps: {shown(self.text)}"

    def load(self) -> Grid:
        """Return its grid.

        Raises:
            AcoexpError: as :func:`acoexp.load_map`, naming the text.
        """
        try:
            return load_map(self.source, **self.parameters)
        except AcoexpError as problem:
            raise type(problem)(f"{self.named}: {problem}") from problem


class MapFacts(NamedTuple):
    """What a report has to know of a map once its trials are done.

    Attributes:
        name: What it is called.
        digest: Its fingerprint.
        optimum: Exact length of a shortest path, in cells.
        side: The longer of its sides, in cells.
        free: Cells that can be entered.
    """

    name: str
    digest: str
    optimum: float
    side: int
    free: int

    @classmethod
    def of(cls, grid: Grid) -> MapFacts:
        """Return what is to be known of a grid."""
        return cls(grid.name, grid.digest, grid.optimum, max(grid.shape), int((~grid.obstacles).sum()))


def parse_maps(texts: Sequence[str]) -> list[MapText]:
    """Return the maps that texts describe, none of which has been loaded.

    Args:
        texts: Each the name of a source, a file, or both as ``source:file``; then the source's keys
            ``map.key=value``, separated by blanks; then ``#`` and the numbers, such as ``0-9,20``, that its
            numbered parameter is to take.

    Raises:
        SettingsError: for a text that describes no map, or more than ``MOST_MAPS`` maps.
        MapError: for a scenario that cannot be read.
        StrategyError: for a source whose package cannot be imported.
    """
    found: list[MapText] = []
    for given in texts:
        text = given.strip()
        try:
            numbers = _numbers(text)
            count = len(found) + (1 if numbers is None else len(numbers))
            if count > MOST_MAPS:
                raise SettingsError(f"expected at most {MOST_MAPS} maps in a report; got {count} up to here")
            found += _parse(text, numbers)
        except AcoexpError as problem:
            raise type(problem)(f"report.maps: {shown(text)}: {problem}") from problem
    return found


def load_distinct(maps: Sequence[MapText]) -> Iterator[Grid]:
    """Yield the grids of maps, one after the other; those of one name are called by their texts.

    Raises:
        SettingsError: if two are the same map: each counts once.
        AcoexpError: as :meth:`MapText.load`.
    """
    known: dict[str, MapText] = {}
    names: set[str] = set()
    for one in maps:
        grid = one.load()
        if grid.digest in known:
            raise SettingsError(
                f"report.maps: expected different maps, as each counts once; {shown(known[grid.digest].text)} and "
                f"{shown(one.text)} are the same"
            )
        known[grid.digest] = one
        yield grid if grid.name not in names else _renamed(grid, one.text)
        names.add(grid.name)


def _parse(text: str, numbers: Seeds | None) -> list[MapText]:
    head, *overrides = _OVERRIDE.split(_NUMBERS.sub("", text))
    source, parameters = _source_and_file(head)
    given = nested(overrides)
    beside = sorted(given.keys() - {"map"})
    if beside or not isinstance(given.get("map", {}), dict):
        raise SettingsError(
            f"expected keys of the map, such as map.moves=no_cut; got {shown(' '.join(overrides))}"
        )
    parameters |= given.get("map", {})
    if numbers is None:
        return [MapText(text=printable(text), source=source, parameters=_complete(source, parameters))]
    key, base = _numbered(source, parameters), printable(text[: text.rindex("#")])
    complete = _complete(source, parameters)
    return [
        MapText(text=f"{base}#{number}", source=source, parameters={**complete, key: number}) for number in numbers
    ]


def _numbered(source: str, parameters: Mapping[str, Any]) -> str:
    """Return the key that the numbers behind ``#`` are of."""
    key: str | None = find_part("map", source).numbered
    if key is None:
        raise SettingsError(f"expected no #, as map={source} has no key whose numbers it could give")
    if key in parameters:
        raise SettingsError(f"expected map.{key} or #, which gives it; got both")
    if source == "movingai" and "scenario" not in parameters:
        raise SettingsError("expected a scenario before #, the numbers of its rows: movingai:arena.map.scen#0-9")
    return key


def _source_and_file(head: str) -> tuple[str, dict[str, Any]]:
    """Return the source that the first word names, or that reads such a file, and its parameters so far."""
    source, colon, file = head.partition(":")
    if not colon or source not in part_names("map"):
        source, file = (
            (head, "") if _is_name(head) else (_BY_ENDING.get(PurePath(head).suffix.lower(), "file"), head)
        )
    if file and source == "movingai" and file.lower().endswith(".scen"):
        return source, {"scenario": file}
    return source, {"path": file} if file else {}


def _is_name(head: str) -> bool:
    """Tell a source's name, also a misspelt one, from a file."""
    return head in part_names("map") or not ("." in head or "/" in head)


def _numbers(text: str) -> Seeds | None:
    """Return the numbers behind ``#``, or None."""
    found = _NUMBERS.search(text)
    try:
        return None if found is None else parse_seeds(found[1])
    except SettingsError as problem:
        raise SettingsError(f"after #: {str(problem).partition(': ')[2]}") from problem


def _complete(source: str, parameters: dict[str, Any]) -> dict[str, Any]:
    """Return parameters with the map that a scenario is for: it lies beside it, unless the text says where."""
    scenario = parameters.get("scenario")
    if source != "movingai" or not isinstance(scenario, str) or "path" in parameters:
        return parameters
    path, text = read_text(scenario, "map.scenario")
    return {"path": str(Path(scenario).parent / parse_instance(text, 0, printable(path.name)).map), **parameters}


def _renamed(grid: Grid, name: str) -> Grid:
    return Grid(
        grid.obstacles,
        start=grid.start,
        goal=grid.goal,
        moves=grid.moves,
        name=name,
        metadata=grid.metadata,
        frame=grid.frame,
    )
