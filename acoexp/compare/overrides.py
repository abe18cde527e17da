"""Texts ``key=value`` within a list, read as the command line reads them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from omegaconf import OmegaConf
from omegaconf.errors import OmegaConfBaseException
from yaml import YAMLError

from acoexp.errors import SettingsError, shown
from acoexp.strategies.groups import STRATEGY_GROUPS

_KEY = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*")


def nested(overrides: Sequence[str]) -> dict[str, Any]:
    """Return ``key=value`` texts as nested settings; a part's name stands under ``name``.

    Raises:
        SettingsError: for a text that is none.
    """
    config = OmegaConf.create({})
    for override in overrides:
        key, _, value = override.partition("=")
        if not _KEY.fullmatch(key) or "=" not in override:
            raise SettingsError(f"expected key=value; got {shown(override)}")
        dotted = f"{key}.name={value}" if key in STRATEGY_GROUPS else override
        try:
            config.merge_with_dotlist([dotted])
        except (OmegaConfBaseException, YAMLError, ValueError, TypeError, RecursionError) as problem:
            raise SettingsError(f"expected key=value, as on the command line; got {shown(override)}") from problem
    found = OmegaConf.to_container(config, resolve=False)
    return {str(key): value for key, value in found.items()} if isinstance(found, dict) else {}
