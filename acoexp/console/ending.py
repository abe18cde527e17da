"""How a command ends: what is wrong in one line on standard error, and a status that a script can read."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from io import TextIOWrapper

from acoexp.console.plain import one_line
from acoexp.errors import AcoexpError, shown

FAILED, INTERRUPTED = 1, 130
"""Exit statuses: anything that is wrong; Ctrl-C, as a shell has it."""


def describe(problem: Exception) -> str | None:
    """Return what is said of an error; None for one that nobody foresaw, which needs its traceback."""
    return said_of(problem) if isinstance(problem, AcoexpError | OSError) else None


def said_of(problem: Exception) -> str:
    """Return what an error says; of the name of a file that is very long only the beginning."""
    if isinstance(problem, OSError) and not isinstance(problem, AcoexpError) and problem.filename is not None:
        return f"[Errno {problem.errno}] {problem.strerror}: {shown(problem.filename)}"
    return str(problem)


@contextmanager
def ends_cleanly(interrupted: str, describe: Callable[[Exception], str | None] = describe) -> Iterator[None]:
    """End the program with one line and a status if anything within is wrong.

    Args:
        interrupted: What is said after Ctrl-C of what had been done by then.
        describe: Returns what is said of an error, or None where it is raised instead.
    """
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # a name that this terminal cannot show ends nothing
    try:
        yield
    except KeyboardInterrupt as ended:  # whoever knows better has said it
        print(f"acoexp: interrupted; {str(ended) or interrupted}", file=sys.stderr)
        sys.exit(INTERRUPTED)
    except Exception as problem:
        message = describe(problem)
        if message is None:
            raise
        print_error(message)
        sys.exit(FAILED)


def print_error(message: str) -> None:
    """Print what is wrong as one line."""
    print(f"acoexp: error: {one_line(message)}", file=sys.stderr)
