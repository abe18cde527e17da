"""Python's collector of cyclic garbage: off while a command is read and gets ready, as nothing of that is garbage.

It would look through all that was imported again and again, which is a sixth of the time that one trial takes.
"""

from __future__ import annotations

import gc

_OFTEN = 20_000
"""Objects after which it looks: a few megabytes. Python's 700 would be within every call of MLflow's."""


def begin_without() -> None:
    """Switch the collector off; a command that does nothing for long ends without it."""
    gc.disable()


def set_aside() -> None:
    """Free what is garbage; what is there then stays, and the collector does not look through it again."""
    gc.collect()
    gc.freeze()


def collect_from_now_on() -> None:
    """Let the collector look through what is made from now on, if it was switched off."""
    if not gc.isenabled():
        gc.freeze()
        gc.set_threshold(_OFTEN)
        gc.enable()
