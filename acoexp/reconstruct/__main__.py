"""``python -m acoexp.reconstruct env=fig13 seed=0 ...``: search for maps, one for each seed."""

from __future__ import annotations

import sys
from typing import Any

from omegaconf import OmegaConf
from yaml import YAMLError

from acoexp.command.messages import print_error
from acoexp.errors import AcoexpError, SettingsError
from acoexp.parameters import build, fields_of
from acoexp.reconstruct.calibration import Calibration

INTERRUPTED = 130


def main(arguments: list[str]) -> None:
    """Run the search; leaves by ``SystemExit`` if anything is wrong."""
    if {"-h", "--help"} & set(arguments):
        print(_help())
        return
    try:
        for file in build(Calibration, _values(arguments)).run():
            print(file)
    except KeyboardInterrupt:
        print("acoexp: interrupted; the maps of finished runs are kept", file=sys.stderr)
        sys.exit(INTERRUPTED)
    except (AcoexpError, OSError) as problem:
        print_error(problem)
        sys.exit(1)


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
    lines = [
        "python -m acoexp.reconstruct [key=value ...]: search for the paper's lost maps, one for each seed",
        "",
    ]
    for name, field in fields_of(Calibration).items():
        lines.append(
            f"  {name}={'' if field.default is None else field.default}".ljust(26) + field.metadata["meaning"]
        )
    return "\n".join(lines)


if __name__ == "__main__":
    main(sys.argv[1:])
