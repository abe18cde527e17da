"""The command's entry: arguments are put in order, options registered, then Hydra takes over."""

from __future__ import annotations

import os
import sys

import hydra
from hydra.errors import HydraException
from omegaconf.errors import OmegaConfBaseException

from acoexp.command import sweep
from acoexp.command.arguments import PARTS_INFO, complete_past_flags, normalise
from acoexp.command.job import run_job
from acoexp.command.messages import print_error
from acoexp.command.options import register_options
from acoexp.command.parts import parts_text
from acoexp.errors import AcoexpError
from acoexp.presets import conf_dir

INTERRUPTED = 130
_ENGINES = ("submitit", "ray", "joblib")
"""Packages whose own errors say that a job was lost with its worker."""


def main() -> None:
    """Run ``acoexp`` with the arguments of this process; leaves by ``SystemExit`` if anything is wrong."""
    wants_traceback = os.environ.get("HYDRA_FULL_ERROR") == "1"
    os.environ["HYDRA_FULL_ERROR"] = "1"  # so that Hydra hands its errors to us instead of printing them
    try:
        arguments = normalise(sys.argv[1:])
        if arguments.info == PARTS_INFO:
            print(parts_text())
            return
        register_options(arguments.config_dir)
        sys.argv[1:] = arguments.argv
        complete_past_flags(os.environ)
        hydra.main(version_base="1.3", config_path=str(conf_dir()), config_name="config")(run_job)()
    except KeyboardInterrupt:
        sweep.finish()
        print("acoexp: interrupted; what was finished is kept", file=sys.stderr)
        sys.exit(INTERRUPTED)
    except (AcoexpError, HydraException, OmegaConfBaseException, OSError) as problem:
        if wants_traceback:
            raise
        sweep.finish()
        print_error(problem)
        sys.exit(1)
    except Exception as problem:
        if wants_traceback or type(problem).__module__.partition(".")[0] not in _ENGINES:
            raise
        sweep.finish()
        print_error(problem)
        sys.exit(1)
    finally:
        sweep.finish()
