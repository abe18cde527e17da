"""Whose a run is: which process writes it, and whether that one still lives."""

from __future__ import annotations

import os
import socket
from functools import cache
from pathlib import Path

import psutil


def this_process() -> str:
    """Return a mark for this process that no other bears, also after a restart of the machine."""
    return f"{_machine()} {os.getpid()} {psutil.Process().create_time():.2f}"


def is_dead(mark: str) -> bool | None:
    """Tell whether a process has ended; None if it ran elsewhere, where nobody here can look."""
    machine, pid, began = mark.rsplit(" ", 2)
    if machine != _machine():
        return None
    try:
        process = psutil.Process(int(pid))
        return f"{process.create_time():.2f}" != began or process.status() == psutil.STATUS_ZOMBIE
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
