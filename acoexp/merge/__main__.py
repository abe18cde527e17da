"""``python -m acoexp.merge STORE ...``: runs that were made elsewhere are brought into one store."""

from __future__ import annotations

import sqlite3
import sys
from argparse import ArgumentParser
from contextlib import closing
from pathlib import Path

from rich.console import Console
from rich.progress import Progress

from acoexp.console.ending import ends_cleanly, print_error
from acoexp.errors import TrackingError
from acoexp.merge.copying import RefusedError, merge
from acoexp.parameters import defaults_of
from acoexp.tracking.mlflow.database import address_of
from acoexp.tracking.mlflow.store import Store
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.open import check_uri, experiment_named
from acoexp.tracking.options import Mlflow


def main(argv: list[str] | None = None) -> None:
    """Run the command; leaves by ``SystemExit`` if anything is wrong."""
    default = defaults_of(Mlflow)["uri"]
    parser = ArgumentParser(
        prog="python -m acoexp.merge",
        description="Bring the finished runs of other stores into one, each trial and each batch once.",
    )
    parser.add_argument(
        "source", nargs="+", help="database file, or address of an MLflow store, to bring runs from"
    )
    parser.add_argument("--into", default=default, metavar="STORE", help="where to bring them [%(default)s]")
    parser.add_argument(
        "--experiment", metavar="NAME", help="experiment to bring, in all stores the same [as tracking.experiment]"
    )
    arguments = parser.parse_args(argv)
    with ends_cleanly("what was brought is kept"):
        experiment = experiment_named(arguments.experiment)
        sources = [_existing(source, experiment) for source in arguments.source]
        target = MlflowTracker(_address(arguments.into), experiment)
        for source in sources:
            if source.uri == target.store.uri:
                raise TrackingError(f"expected a store other than the one to bring runs into; got {source.shown}")
        target.prepare()
        refused = [problem for source in sources for problem in _merge(source, target.store)]
        for problem in refused[:-1]:
            print_error(str(problem))
        if refused:
            raise refused[-1]


def _merge(source: Store, target: Store) -> list[RefusedError]:
    """Bring the runs of one store and say how many; return what was refused, if anything was."""
    refused: list[RefusedError] = []
    console = Console(file=sys.stderr)
    with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task("runs", total=None)
        try:
            merged = merge(source, target, lambda done, runs: progress.update(task, completed=done, total=runs))
        except RefusedError as problem:
            merged = problem.merged
            refused.append(problem)
    print(
        f"{merged.brought} runs brought from {source.shown}; {merged.known} were there already, "
        f"{merged.left} are not finished" + (f", {merged.refused} are refused" if merged.refused else "")
    )
    return refused


def _existing(text: str, experiment: str) -> Store:
    store = Store(_address(text), experiment)
    if store.file is not None and not store.file.is_file():
        raise TrackingError(f"expected an MLflow database to bring runs from; there is no file {store.file}")
    if store.file is not None and not _is_mlflows(store.file):
        raise TrackingError(f"expected an MLflow database to bring runs from; {store.file} is none")
    store.check_there()
    return store


def _is_mlflows(file: Path) -> bool:
    """Look for MLflow's table, so that MLflow does not lay its own out in what is no store of its."""
    try:
        with closing(sqlite3.connect(f"{file.absolute().as_uri()}?mode=ro", uri=True)) as database:
            return bool(database.execute("SELECT 1 FROM sqlite_master WHERE name = 'experiments'").fetchone())
    except sqlite3.OperationalError:  # locked, which is told when it is opened
        return True
    except sqlite3.DatabaseError:
        return False


def _address(text: str) -> str:
    """Return the address of a store that is named by it, or by its database file."""
    return check_uri(text if "://" in text else address_of(Path(text)))


if __name__ == "__main__":
    main()
