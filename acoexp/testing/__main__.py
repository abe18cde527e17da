"""``python -m acoexp.testing module:Class PARAMETERS ALGO SETTINGS``: the digest of all that a part does.

The last three are JSON: the part's parameters, a preset, and further settings.
"""

from __future__ import annotations

import json
import sys
from importlib import import_module

from acoexp.errors import AcoexpError
from acoexp.parameters import build
from acoexp.testing.checks import digest


def main(where: str, parameters: str, algo: str, settings: str) -> None:
    """Print the digest of a part that is named by module and class."""
    module, _, name = where.partition(":")
    part = build(getattr(import_module(module), name), json.loads(parameters))
    print(digest(part, json.loads(algo), json.loads(settings)))


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AcoexpError as problem:
        sys.exit(str(problem))
