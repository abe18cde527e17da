"""``python -m acoexp``: the command line."""

from acoexp.command.main import main

if __name__ == "__main__":
    main()
