"""From the ``tracking`` part of a configuration to the tracker that it asks for."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from acoexp.errors import SettingsError, did_you_mean
from acoexp.parameters import REQUIRED, build
from acoexp.tracking.mlflow.masking import masked
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.options import TRACKING, Mlflow
from acoexp.tracking.tracker import NoTracker, Tracker

_IN_MEMORY = re.compile(r"^sqlite[^:]*:/*(\?|$)|:memory:|mode=memory")


def open_tracker(config: Mapping[str, Any]) -> Tracker:
    """Return the tracker for the ``tracking`` part of a configuration; nothing is imported or touched yet.

    Args:
        config: Its ``name``, and its parameters.

    Raises:
        SettingsError: if its name is unknown, a key is, or the address is none of a store that lasts.
    """
    parameters = dict(config)
    name = parameters.pop("name", None)
    if not isinstance(name, str) or name not in TRACKING:
        like = did_you_mean(name, TRACKING)
        raise SettingsError(f"tracking: expected one of: {', '.join(TRACKING)}; got {name!r}{like}")
    chosen = build(TRACKING[name], parameters, "tracking.")
    return MlflowTracker(check_uri(chosen.uri)) if isinstance(chosen, Mlflow) else NoTracker()


def check_uri(uri: str, key: str = "tracking.uri", what: str = "an MLflow store") -> str:
    """Return the address of a store that lasts.

    Args:
        uri: The address.
        key: What it was given for.
        what: What it is to be of.

    Raises:
        SettingsError: if it is none.
    """
    if uri in ("", REQUIRED) or _IN_MEMORY.search(uri):
        shown = masked(uri, uri)
        raise SettingsError(f"{key}: expected the address of {what} that lasts; got {shown!r}")
    return uri
