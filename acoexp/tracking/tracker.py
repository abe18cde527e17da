"""What a tracker is, and which one a configuration asks for."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

from acoexp.errors import SettingsError
from acoexp.parameters import REQUIRED
from acoexp.result import Result

_NOT_OF_THE_TRIAL = ("tracking", "report")
"""Parts of a configuration on which no result depends; an address may also hold a password."""


@dataclass(frozen=True)
class Trial:
    """A finished trial and the configuration that it came from.

    Attributes:
        result: What was found.
        config: The resolved configuration, nested.
    """

    result: Result
    config: Mapping[str, Any]

    @cached_property
    def params(self) -> dict[str, str]:
        """The configuration, flattened: ``diffusion.gamma`` and so on, in order."""
        trial = {key: value for key, value in self.config.items() if key not in _NOT_OF_THE_TRIAL}
        return {**dict(flatten(trial)), "algo": self.result.algo}

    @cached_property
    def cell(self) -> str:
        """A fingerprint of the configuration without the seed, the same for all trials to be averaged."""
        cell = {key: value for key, value in self.params.items() if key != "seed"}
        content = json.dumps([cell, self.result.grid.digest], sort_keys=True)
        return hashlib.sha256(content.encode()).hexdigest()[:16]


_IN_MEMORY = re.compile(r"^sqlite[^:]*:/*(\?|$)|:memory:|mode=memory")


class Tracker(Protocol):
    """Keeps finished trials."""

    where: str
    """What to tell a person about where results lie."""

    def prepare(self) -> None:
        """Create the store if it is not there; called once, before any trial.

        Raises:
            TrackingError: if it cannot be reached or written.
        """

    def log(self, trial: Trial) -> None:
        """Keep one trial, whole or not at all.

        Raises:
            TrackingError: if it cannot be kept.
        """


class NoTracker:
    """``tracking=none``: keeps nothing."""

    where = "not tracked"

    def prepare(self) -> None:
        """Do nothing."""

    def log(self, trial: Trial) -> None:
        """Do nothing."""


def open_tracker(config: Mapping[str, Any]) -> Tracker:
    """Return the tracker for the ``tracking`` part of a configuration; nothing is imported or touched yet.

    Raises:
        SettingsError: if its name is unknown, a key is, or the address is not a text.
    """
    from acoexp.tracking.mlflow_store import MlflowTracker

    allowed = {"none": {"name"}, "mlflow": {"name", "uri"}}
    name = config.get("name")
    if name not in allowed:
        raise SettingsError(f"tracking: expected one of: {', '.join(sorted(allowed))}; got {name!r}")
    for key in config.keys() - allowed[name]:
        raise SettingsError(f"tracking.{key} is not a known key of tracking={name}")
    if name == "none":
        return NoTracker()
    uri = config.get("uri")
    if not isinstance(uri, str) or uri in ("", REQUIRED) or _IN_MEMORY.search(uri):
        raise SettingsError(f"tracking.uri: expected the address of an MLflow store that lasts; got {uri!r}")
    return MlflowTracker(uri)


def flatten(config: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, str]]:
    """Yield ``(dotted key, value as text)`` for every leaf of a nested configuration."""
    for key, value in config.items():
        if isinstance(value, Mapping):
            yield from flatten(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", str(value)
