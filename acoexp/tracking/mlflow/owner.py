"""Whose a run is: which process writes it, and whether that one still lives."""

from __future__ import annotations

import os
import re
import socket
from functools import cache
from pathlib import Path

import psutil

_CLOCK_SET = 5.0
"""Seconds by which a clock that is set may move the start of a process."""
_MARK = re.compile(r".+ \d{1,9} \d+\.\d+", re.ASCII)


def this_process() -> str:
    """Return a mark for this process that no other bears, also after a restart of the machine."""
    return f"{_machine()} {os.getpid()} {psutil.Process().create_time():.2f}"


def is_mark(text: str) -> bool:
    """Tell whether a text is a mark of some process, and not what a person wrote in its place."""
    return _MARK.fullmatch(text) is not None


def is_dead(mark: str) -> bool | None:
    """Tell whether a process has ended; None if it ran elsewhere, where nobody here can look."""
    machine, pid, began = mark.rsplit(" ", 2)
    if machine != _machine():
        return None
    try:
        process = psutil.Process(int(pid))
        # the system's clock may have been set since, which moves the start of every process
        another = abs(process.create_time() - float(began)) > _CLOCK_SET
        return another or process.status() == psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return True


@cache
def _machine() -> str:
    """Return a name for the space in which process numbers count: the host, its start, and the container."""
    try:
        boot = Path("/proc/sys/kernel/random/boot_id").read_text(encoding="ascii").strip()
        space = str(Path("/proc/self/ns/pid").readlink())
    except OSError:  # not Linux
        boot = space = "-"
    return f"{socket.gethostname()} {boot} {space}"
