"""Identity: what a result depends on, as digests. Two trials of one identity find the same, bit for bit.

That is the resolved settings, the map, the seed, and the code that takes part: acoexp's own in five whole folders,
and the whole top-level package of each other part. Processors are not in it, so a trial that another machine ran
is the same trial.
"""

from __future__ import annotations

import hashlib
import json
import sys
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any

import numba
import numpy as np

from acoexp.grid.grid import Grid
from acoexp.kernels.digest import digest_of_sources
from acoexp.trial.seeds import Seeds

_OWN_PACKAGE = __name__.partition(".")[0]

TAKES_PART = ("colony", "grid", "kernels", "strategies", "trial")
"""The folders of acoexp that a result depends on."""


def configuration_id(settings: Mapping[str, Any], parts: Iterable[object], grid: Grid) -> str:
    """Return the identity of all trials of one configuration on one map: everything but the seed.

    Args:
        settings: The resolved settings as plain values.
        parts: The parts that they chose.
        grid: The map.
    """
    packages = {package for part in parts for package in _packages(part)}
    code = [_code(package) for package in sorted(packages | {_OWN_PACKAGE})]
    return _digest([settings, grid.name, grid.digest, code, numba.__version__, np.__version__])


def trial_identity(configuration: str, seeds: object) -> str:
    """Return the identity of one trial of a configuration, or of a batch of them.

    Args:
        configuration: The configuration's identity.
        seeds: The trial's seed, or the batch's seeds.
    """
    return _digest([configuration, "batch" if isinstance(seeds, Seeds) else "trial", str(seeds)])


def _packages(part: object) -> set[str]:
    """Return the top-level packages that a part's class, its bases and its kernel come from."""
    kernel = getattr(part, "kernel", None)
    modules = [base.__module__ for base in type(part).__mro__]
    modules.append(getattr(getattr(kernel, "py_func", kernel), "__module__", _OWN_PACKAGE))
    return {module.partition(".")[0] for module in modules} - sys.stdlib_module_names


@cache
def _code(package: str) -> str | None:
    return digest_of_sources(package, only=TAKES_PART if package == _OWN_PACKAGE else None)


def _digest(content: object) -> str:
    return hashlib.sha256(json.dumps(content, sort_keys=True, default=str).encode()).hexdigest()[:32]
