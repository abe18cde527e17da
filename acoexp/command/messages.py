"""Errors as a person reads them: one line on standard error, Hydra's in our words."""

from __future__ import annotations

import re
from typing import Any

from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import InterpolationResolutionError

from acoexp.command.options.reading import line_to_type
from acoexp.console.ending import said_of
from acoexp.console.plain import one_line
from acoexp.errors import did_you_mean
from acoexp.registry.entries import GROUPS, not_found
from acoexp.registry.parts import key_of_another
from acoexp.tracking.mlflow.masking import masked

_EXTRAS = {
    "hydra/launcher/joblib": ("engine", "joblib"),
    "hydra/launcher/submitit_slurm": ("engine", "slurm"),
    "hydra/launcher/ray": ("engine", "ray"),
}
"""What comes with an extra: its group, and the name that it and the extra have."""


def in_one_line(problem: Exception) -> str:
    """Return an error's message as one line."""
    if isinstance(problem, InterpolationResolutionError):
        return _unresolved(problem)
    text = masked(one_line(said_of(problem).partition("Config search path")[0]))
    unknown = re.match(r"Could not override '([^']+)'", text)
    if unknown:
        return _unknown_key(unknown[1], getattr(problem.__cause__, "parent_node", None))
    lacking = re.search("Could not find '(hydra/launcher/\\w+)'", text)
    if lacking and lacking[1] in _EXTRAS:
        group, name = _EXTRAS[lacking[1]]
        return needs_extra(group, name)
    missing = re.match(r"In '[^']+': Could not find '([^']+)/([^/']+)' Available options in '[^']+': (.*)", text)
    if missing:
        return not_found(missing[1], missing[2], missing[3].split())
    return text or type(problem).__name__


def needs_extra(group: str, name: str) -> str:
    """Say how to install what an option of a group needs; it has the extra's name."""
    return f'{group}: {name} needs `pip install "acoexp[{name}]"`'


def _unresolved(problem: InterpolationResolutionError) -> str:
    """Say which key's reference leads nowhere, and how its text is written if it was meant to be none."""
    key, said = str(problem.full_key), str(problem).splitlines()[0]
    if key.startswith("hydra."):  # names of its folders cannot have it
        return f"{key}: {said}"
    values: Any = OmegaConf.to_container(problem.parent_node, resolve=False) if problem.parent_node else {}
    text = values[problem.key] if isinstance(values, dict) else None
    what = f"type {line_to_type(key, text)}" if isinstance(text, str) else "write it as '\\${'"
    return f"{key}: {said}; where '${{' is meant as it stands, {what}"


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
