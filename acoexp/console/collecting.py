"""Python's collector of cyclic garbage: off while a command is read and gets ready, as nothing of that is garbage.

It would look through all that was imported again and again, which is a sixth of the time that one trial takes.
"""

from __future__ import annotations

import gc


def begin_without() -> None:
    """Switch the collector off; a command that does nothing for long ends without it."""
    gc.disable()


def collect_from_now_on() -> None:
    """Let the collector look through what is made from now on, if it was switched off."""
    if not gc.isenabled():
        gc.freeze()
        gc.enable()
