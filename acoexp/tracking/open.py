"""From the ``tracking`` part of a configuration to the tracker that it asks for."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from typing import Any

from acoexp.errors import SettingsError, did_you_mean, shown
from acoexp.parameters import REQUIRED, build
from acoexp.tracking.mlflow.masking import masked
from acoexp.tracking.mlflow.store import EXPERIMENT
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.options import EXPERIMENT_VARIABLE, TRACKING, Mlflow
from acoexp.tracking.tracker import NoTracker, Tracker

_LONGEST_NAME = 250
_IN_MEMORY = re.compile(r"^sqlite[^:]*:/*(\?|$)|:memory:|mode=memory")


def open_tracker(config: Mapping[str, Any]) -> Tracker:
    """Return the tracker for the ``tracking`` part of a configuration; nothing is imported or touched yet.

    Args:
        config: Its ``name``, and its parameters.

    Raises:
        SettingsError: if its name is unknown, a key is, the address is none of a store that lasts, or no
            experiment can have that name.
    """
    parameters = dict(config)
    name = parameters.pop("name", None)
    if not isinstance(name, str) or name not in TRACKING:
        like = did_you_mean(name, TRACKING)
        raise SettingsError(f"tracking: expected one of: {', '.join(TRACKING)}; got {name!r}{like}")
    chosen = build(TRACKING[name], parameters, "tracking.")
    if isinstance(chosen, Mlflow):
        return MlflowTracker(check_uri(chosen.uri), experiment_named(chosen.experiment))
    return NoTracker()


def experiment_named(name: str | None) -> str:
    """Return the name of an experiment; where none is given that of the environment, or else ``EXPERIMENT``.

    Raises:
        SettingsError: if none can have it.
    """
    if name is None:
        name = os.environ.get(EXPERIMENT_VARIABLE) or EXPERIMENT
    if not (1 <= len(name) <= _LONGEST_NAME and name.isprintable() and name == name.strip()) or name == REQUIRED:
        raise SettingsError(
            f"tracking.experiment, or {EXPERIMENT_VARIABLE}: expected a name of 1 to {_LONGEST_NAME} characters "
            f"that can be shown, with no blank at either end; got {shown(name)}"
        )
    return name


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
