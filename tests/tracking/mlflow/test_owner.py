"""Whose a run is: a process is known again as long as it lives, and nobody is taken for it afterwards."""

from __future__ import annotations

import subprocess
import sys
import time

import psutil
import pytest

from acoexp.tracking.mlflow.owner import is_dead, is_mark, this_process

MACHINE, PID, BEGAN = this_process().rsplit(" ", 2)


def test_a_mark_is_told_from_what_a_person_may_write_in_its_place() -> None:
    assert is_mark(this_process())
    assert not any(map(is_mark, ["", "alice", "alice 1", "a b c", " 1 1.0", f"a {'9' * 30} 1.0", "a 1 nan"]))


def test_a_process_that_asks_lives() -> None:
    assert is_dead(this_process()) is False


def test_a_process_that_was_killed_is_dead_whether_its_parent_has_looked_or_not() -> None:
    process = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    mark = f"{MACHINE} {process.pid} {psutil.Process(process.pid).create_time():.2f}"
    assert is_dead(mark) is False
    process.kill()
    until_zombie(process.pid)
    assert is_dead(mark) is True
    process.wait(timeout=10.0)
    assert is_dead(mark) is True


def until_zombie(pid: int) -> None:
    """Wait until a killed process has ended, without asking how, as its parent would."""
    deadline = time.monotonic() + 10.0
    while psutil.Process(pid).status() != psutil.STATUS_ZOMBIE:
        assert time.monotonic() < deadline
        time.sleep(0.01)


@pytest.mark.parametrize(("later", "dead"), [(-4.0, False), (4.0, False), (-6.0, True), (6.0, True)])
def test_a_number_that_was_given_to_another_process_is_told_from_a_clock_that_was_set(
    later: float, dead: bool
) -> None:
    assert is_dead(f"{MACHINE} {PID} {float(BEGAN) + later:.2f}") is dead


def test_of_another_machine_nobody_here_can_know() -> None:
    assert is_dead(f"another-host boot space {PID} {BEGAN}") is None


def test_a_restart_of_the_machine_makes_it_another() -> None:
    host, boot, space = MACHINE.split(" ")
    if boot == "-":
        pytest.skip("only Linux tells")
    assert is_dead(f"{host} {boot[::-1]} {space} {PID} {BEGAN}") is None
