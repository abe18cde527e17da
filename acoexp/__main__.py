"""``python -m acoexp``: the command line."""

from __future__ import annotations

import sys


def main() -> None:
    """Run the command. What it needs takes a second to import, and Ctrl-C is answered within that, too."""
    try:
        from acoexp.command.main import main as run
    except KeyboardInterrupt:
        print("acoexp: interrupted; nothing was begun", file=sys.stderr)
        sys.exit(130)
    run()


if __name__ == "__main__":
    main()
