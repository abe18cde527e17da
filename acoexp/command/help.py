"""``--help``: every group and option in one line each, from the declarations themselves."""

from __future__ import annotations

import inspect
import re
from typing import Any

from acoexp import registry
from acoexp.colony.problem import ColonySettings
from acoexp.errors import StrategyError
from acoexp.field import FieldSettings
from acoexp.parameters import fields_of
from acoexp.presets import conf_dir, find_preset, preset_names

_EXAMPLES = """\
acoexp: ant-colony path planning of mobile robots on occupancy grids

  python -m acoexp                                       one trial: pictures and figures
  python -m acoexp algo=pdg map=env2 -m seed=0-9         ten trials, tracked
  python -m acoexp map=file map.path=my_map.txt          your own map
  python -m acoexp algo=aco,pd,pdg map=env2 -m seed=0-9  compare
  python -m acoexp algo=aco,pd,pdg -m seeds=0-999        three batches of a thousand trials

Say group=option, or key=value. Sweep over several values by -m: seed=0-4,7 algo=aco,pdg rho=0.3,0.5
If nothing is said: algo=pdg map=fig13 seed=0 tracking=mlflow engine=basic report=none
"""


def help_text() -> str:
    """Return the help as a template for Hydra, which fills in its own flags."""
    sections = [_EXAMPLES, _presets(), *map(_group, registry.GROUPS), *map(_files, _FILES), _scalars(), _FLAGS]
    return "\n".join(sections)


_FLAGS = """\
== Flags ==
-m runs a sweep; --cfg job shows the resolved settings; --info strategies lists every part with its
package, contract and parameters; --info shows where settings come from; --hydra-help tells of
Hydra's own flags. Completion: eval "$$(acoexp -sc install=bash)"
"""


def _presets() -> str:
    return _section(
        "algo", "a preset over the five parts below", {name: _preset_summary(name) for name in preset_names()}
    )


def _preset_summary(name: str) -> str:
    try:
        return find_preset(name).summary
    except StrategyError as problem:
        return f"BROKEN: {problem}"


def _group(group: str) -> str:
    about = {
        "heuristic": "how desirable a move is before the first cycle",
        "choice": "which move an ant makes",
        "diffusion": "what pheromone does at every step",
        "post": "how an ant's path is made better",
        "update": "what happens to pheromone after a cycle",
        "map": "where the map comes from",
        "report": "what is made of the results",
    }
    lines = {name: _describe(group, name) for name in registry.names(group)}
    options = {**_summaries(group), **lines}
    return _section(group, about[group], options)


def _describe(group: str, name: str) -> str:
    try:
        owner = registry.find(group, name)
    except StrategyError as problem:
        return f"BROKEN: {problem}"
    summary = (inspect.getdoc(owner) or "").partition("\n")[0]
    return summary + "".join(f"\n    {group}.{key}: {text}" for key, text in _keys(owner).items())


_FILES = {"tracking": "where results go", "engine": "where the jobs of a sweep run"}
"""Groups whose options are files of ours alone."""


def _files(group: str) -> str:
    return _section(group, _FILES[group], _summaries(group))


def _summaries(group: str) -> dict[str, str]:
    """Return the first remark of each YAML file of a group."""
    files = sorted((conf_dir() / group).glob("*.yaml"))
    return {file.stem: re.findall(r"^# ([^@].*)$", file.read_text("utf-8"), re.M)[0] for file in files}


def _scalars() -> str:
    keys = {
        "seed": "whole number that the trial's random numbers follow from [0]",
        "seeds": "instead, those of a batch, such as 0-999: one run with a table of its trials [null]",
        "threads": "threads that run a batch; one for each processor if null [null]",
        "resume": "whether what the store has of the same trials is taken from there [true]",
    }
    keys |= _keys(ColonySettings) | {f"field.{key}": text for key, text in _keys(FieldSettings).items()}
    return _section("keys", "key=value", keys)


def _keys(owner: Any) -> dict[str, str]:
    """Return each parameter's meaning, its default, and what else it may be where that is one of a few."""
    lines = {}
    for name, field in fields_of(owner).items():
        others = [choice for choice in field.metadata["choices"] or () if choice != field.default]
        values = _default(field.default) + (f", or {', '.join(others)}" if others else "")
        lines[name] = f"{field.metadata['meaning']} [{values}]"
    return lines


def _default(value: Any) -> str:
    if isinstance(value, tuple):
        return ", ".join(map(str, value))
    return "null" if value is None else str(value)


def _section(title: str, about: str, lines: dict[str, str]) -> str:
    width = max(map(len, lines), default=0)
    body = "".join(f"  {name:<{width}}  {text}\n" for name, text in lines.items())
    return f"== {title}: {about} ==\n" + body.replace("$", "$$")
