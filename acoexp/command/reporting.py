"""The report that a command asks for: which one, and the folder that it goes to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode

from acoexp.command.options.folders import is_named
from acoexp.command.options.keys import ReportKeys
from acoexp.errors import SettingsError, shown
from acoexp.parameters import build, fields_of
from acoexp.registry.parts import build_part, find_part
from acoexp.report.context import Context
from acoexp.report.folder import check_folder

_REPORTS = Path("outputs/reports")


@dataclass(frozen=True)
class Asked:
    """A report that is asked for.

    Attributes:
        report: The report, as the registry makes it.
        given: What is said of it, by key, as far as it depends on that.
        folder: The folder that the user named; None if it goes where reports go.
    """

    report: Any
    given: Mapping[str, Any]
    folder: Path | None

    def check_folder(self) -> None:
        """Refuse a named folder that no report may take the place of.

        Raises:
            SettingsError: if it is one.
        """
        if self.folder is not None:
            used = [Path(), _REPORTS]
            if HydraConfig.initialized():  # by then the job has a folder
                used.append(Path(HydraConfig.get().runtime.output_dir))
            check_folder(self.folder, used)

    def place(self, job: Path) -> Path:
        """Return where it goes; without a named folder to one of its name, among reports or in the job's folder.

        Args:
            job: The job's folder.
        """
        if self.folder is not None:
            return self.folder
        hydra, name = HydraConfig.get(), str(self.given["name"])
        if hydra.mode != RunMode.RUN:
            return job / name
        return (Path(hydra.run.dir) if is_named(hydra.run.dir) else _REPORTS) / name

    def write(self, context: Context) -> tuple[Path, Sequence[Sequence[str]]]:
        """Write it; return where it is, and its short table."""
        self.check_folder()  # once more: by now there is a store, and whatever others have written
        with context.place():
            written = self.report.write(context)
        return written, self.report.headline(written)


def asked_report(config: Mapping[str, Any]) -> Asked | None:
    """Return the report that a configuration asks for, or None.

    Args:
        config: What it says of a report, by key.

    Raises:
        SettingsError: for a report or a key that is not known, a value that it may not have, and a folder that no
            report may take the place of.
        StrategyError: for a report whose package cannot be imported.
    """
    parameters = dict(config)
    name = parameters.pop("name", None)
    if name == "none":
        for key in parameters:
            raise SettingsError(f"report.{key} is not a known key of report=none")
        return None
    own = fields_of(find_part("report", name))  # where a report has such a key itself, it means what that means
    shared = {key: parameters.pop(key) for key in fields_of(ReportKeys) if key in parameters and key not in own}
    report = build_part("report", name, parameters)
    keys: ReportKeys = build(ReportKeys, shared, "report.")
    asked = Asked(report, {"name": name, **parameters}, None if keys.folder is None else _path(keys.folder))
    asked.check_folder()
    return asked


def _path(folder: str) -> Path:
    try:
        return Path(folder).expanduser()
    except RuntimeError as problem:
        raise SettingsError(f"report.folder: expected a folder; got {shown(folder)}: {problem}") from problem
