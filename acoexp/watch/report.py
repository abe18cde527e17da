"""``report=watch``: one page on which the ants of a trial find their way, or those of up to four side by side."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from acoexp.compare.configuration import parse_configurations
from acoexp.errors import SettingsError
from acoexp.parameters import parameter
from acoexp.report.context import Context
from acoexp.report.report import Report
from acoexp.trial.recorder import check_size
from acoexp.trial.settings import Settings
from acoexp.watch.packing import Packed, packed
from acoexp.watch.page import data_of, page_of
from acoexp.watch.recording import recording_of

MOST_CELLS = 4
"""Colonies that there is room for on a screen."""

_PAGE = "index.html"


@dataclass(frozen=True, kw_only=True)
class Watch(Report):
    """Ants at work: map, pheromone, ways and best path, cycle by cycle, on a page that plays them."""

    cells: tuple[str, ...] = parameter(
        (), "two to four to watch side by side, written as those of report=compare; by default the command line's"
    )

    def check(self, context: Context) -> None:
        """Refuse cells that are not known, more than fit, too large ones, and parts that no cell would use."""
        for settings in self._settings(context).values():
            check_size(context.grid, settings)

    def write(self, context: Context) -> Path:
        """Run the trials with the command line's seed and write the page."""
        # one after another: a recording takes far more memory than what is packed of it
        page = page_of([_packed(context, name, settings) for name, settings in self._settings(context).items()])
        with context.draft() as folder:
            (folder / _PAGE).write_text(page, encoding="utf-8")
        return context.folder

    def headline(self, folder: Path) -> Sequence[Sequence[str]]:
        """Return what each trial found."""
        data = data_of((folder / _PAGE).read_text(encoding="utf-8"))
        rows = [[one["name"], *_found(one), str(sum(one["lost"]))] for one in data["colonies"]]
        return [["cell", "l1", "x1", "lost"], *rows]

    def _settings(self, context: Context) -> Mapping[str, Settings]:
        """Return the settings of each trial by what it is called."""
        if not self.cells:
            return {context.settings.label: context.settings}
        if context.own_parts:
            raise SettingsError(
                f"{', '.join(context.own_parts)}: expected within report.cells, such as "
                "'pdg diffusion.gamma=0.02'; beside report.cells the command line's own parts are not used"
            )
        if len(self.cells) > MOST_CELLS:
            raise SettingsError(f"report.cells: expected two to {MOST_CELLS} to watch; got {len(self.cells)}")
        parsed = parse_configurations(self.cells, context.own_settings)
        return {one.label: one.settings for one in parsed}


def _packed(context: Context, name: str, settings: Settings) -> Packed:
    colony = packed(name, recording_of(context.grid, settings, context.seed))
    context.show(name, 1)
    return colony


def _found(colony: Mapping[str, list[Mapping[str, float]]]) -> list[str]:
    """Return the best length and the cycle that found it, as the page has them."""
    return (
        [f"{colony['bests'][-1]['length']:.4f}", str(colony["bests"][-1]["cycle"])]
        if colony["bests"]
        else ["-"] * 2
    )
