"""Errors as a person reads them: one line on standard error, Hydra's in our words."""

from __future__ import annotations

import re

from omegaconf import DictConfig

from acoexp.errors import did_you_mean
from acoexp.registry.entries import GROUPS, not_found
from acoexp.registry.parts import key_of_another

_EXTRAS = {
    "hydra/launcher/joblib": ("engine", "joblib"),
    "hydra/launcher/submitit_slurm": ("engine", "slurm"),
    "hydra/launcher/ray": ("engine", "ray"),
    "hydra/sweeper/optuna": ("hydra/sweeper", "optuna"),
}
"""What comes with an extra: its group, and the name that it and the extra have."""


def in_one_line(problem: Exception) -> str:
    """Return an error's message as one line."""
    text = " ".join(str(problem).partition("Config search path")[0].split())
    unknown = re.match(r"Could not override '([^']+)'", text)
    if unknown:
        return _unknown_key(unknown[1], getattr(problem.__cause__, "parent_node", None))
    lacking = re.search("Could not find '(hydra/(?:launcher|sweeper)/\\w+)'", text)
    if lacking and lacking[1] in _EXTRAS:
        group, name = _EXTRAS[lacking[1]]
        return f"{group}: {name} needs `pip install acoexp[{name}]`"
    missing = re.match(r"In '[^']+': Could not find '([^/']+)/([^']+)' Available options in '[^']+': (.*)", text)
    if missing:
        return not_found(missing[1], missing[2], missing[3].split())
    return text or type(problem).__name__


def _unknown_key(key: str, node: DictConfig | None) -> str:
    """Say that there is no such key in a node of the configuration, and what may have been meant."""
    group, _, last = key.rpartition(".")
    known = [] if node is None else [str(other) for other in node if other not in ("hydra", "name")]
    if node is not None and group in GROUPS:
        refusal = key_of_another(group, node.get("name"), last)
        if refusal is not None:
            return refusal
    like = did_you_mean(last, known)
    return f"{key} is not a known key; --help lists the keys, --cfg job shows the settings{like}"
