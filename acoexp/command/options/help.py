"""``--help``: every group and option in one line each, from the declarations themselves."""

from __future__ import annotations

import re

from acoexp.colony.scalars import ColonySettings
from acoexp.command.options.keys import JobKeys, ReportKeys
from acoexp.console.parameters import described_parameters, in_columns, summary_of
from acoexp.errors import StrategyError
from acoexp.grid.field import FieldSettings
from acoexp.registry.entries import GROUPS, part_names
from acoexp.registry.folders import conf_dir
from acoexp.registry.parts import find_part
from acoexp.registry.presets import find_preset, preset_names
from acoexp.tracking.options import TRACKING

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
    sections = [_EXAMPLES, _presets(), *map(_group, GROUPS), _tracking(), _engines(), _keys(), _FLAGS]
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
    options = {name: _describe(group, name) for name in part_names(group)}
    if group == "report":
        options = {"none": "No report", **options, **described_parameters(ReportKeys, "report.")}
    return _section(group, about[group], options)


def _describe(group: str, name: str) -> str:
    try:
        owner = find_part(group, name)
    except StrategyError as problem:
        return f"BROKEN: {problem}"
    return _with_parameters(owner, group)


def _with_parameters(owner: type, group: str) -> str:
    parameters = described_parameters(owner, f"{group}.")
    return summary_of(owner) + "".join(f"\n    {key}: {text}" for key, text in parameters.items())


def _tracking() -> str:
    options = {name: _with_parameters(owner, "tracking") for name, owner in TRACKING.items()}
    return _section("tracking", "where results go", options)


def _engines() -> str:
    """Return the engines, whose options are files: each with its first remark."""
    files = sorted((conf_dir() / "engine").glob("*.yaml"))
    remarks = {file.stem: re.findall(r"^# ([^@].*)$", file.read_text("utf-8"), re.M)[0] for file in files}
    return _section("engine", "where the jobs of a sweep run", remarks)


def _keys() -> str:
    owners = ((JobKeys, ""), (ColonySettings, ""), (FieldSettings, "field."))
    keys = {key: text for owner, prefix in owners for key, text in described_parameters(owner, prefix).items()}
    return _section("keys", "key=value", keys)


def _section(title: str, about: str, lines: dict[str, str]) -> str:
    return f"== {title}: {about} ==\n" + in_columns(lines).replace("$", "$$")
