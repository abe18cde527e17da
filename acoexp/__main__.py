"""``python -m acoexp``: the command line."""

from __future__ import annotations

import signal
import sys


def main() -> None:
    """Run the command. What it needs takes a second to import, and Ctrl-C is answered within that, too."""
    try:
        try:
            from acoexp.console.collecting import begin_without

            begin_without()
            from acoexp.command.main import main as run
        except KeyboardInterrupt:
            print("acoexp: interrupted; nothing was begun", file=sys.stderr)
            sys.exit(130)
        run()
    finally:
        # all is said and kept; Ctrl-C would end what is left, Python's own tidying up, with another status
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        # where it met an exec(), Python would end by that signal, not with our status; the next exec() forgets it
        exec("")


if __name__ == "__main__":
    main()
