"""``python -m acoexp.reconstruct env=fig13 seed=0 ...``: search for maps, one for each seed."""

from __future__ import annotations

import sys
from typing import Any

from omegaconf import OmegaConf
from yaml import YAMLError

from acoexp.console.ending import ends_cleanly
from acoexp.console.parameters import described_parameters, in_columns
from acoexp.errors import SettingsError
from acoexp.parameters import build
from acoexp.reconstruct.calibration import Calibration


def main(arguments: list[str]) -> None:
    """Run the search; leaves by ``SystemExit`` if anything is wrong."""
    if {"-h", "--help"} & set(arguments):
        print(_help(), end="")
        return
    with ends_cleanly("the maps of finished runs are kept"):
        for file in build(Calibration, _values(arguments)).run():
            print(file)


def _values(arguments: list[str]) -> dict[str, Any]:
    for argument in arguments:
        if "=" not in argument:
            raise SettingsError(f"expected key=value; got {argument!r}")
    try:
        values: Any = OmegaConf.to_container(OmegaConf.from_dotlist(arguments))
    except YAMLError as problem:
        raise SettingsError(f"expected key=value with a plain value; got {' '.join(arguments)!r}") from problem
    return {str(key): value for key, value in values.items()}


def _help() -> str:
    heading = "python -m acoexp.reconstruct [key=value ...]: search for the paper's lost maps, one for each seed"
    return f"{heading}\n\n{in_columns(described_parameters(Calibration))}"


if __name__ == "__main__":
    main(sys.argv[1:])
