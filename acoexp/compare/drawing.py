"""What the comparison's pictures share: how lines look, how they are named, how a figure is saved."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import StrMethodFormatter

from acoexp.report.labels import any_signs, as_it_is
from acoexp.report.palette import DASHES, SERIES

PLAIN = StrMethodFormatter("{x:g}")
"""Numbers on an axis as they are: 100, not ten to the power of two."""


def look(place: int) -> dict[str, Any]:
    """Return colour and dashes of the line of a configuration, by its place among them."""
    return {"color": SERIES[place % len(SERIES)], "linestyle": DASHES[place % len(DASHES)]}


def add_legend(figure: Figure, lines: Sequence[Artist], labels: Sequence[str], title: str) -> None:
    """Name lines below the figure; by texts that are set later, as a legend leaves out what begins with ``_``."""
    blanks = [" "] * len(labels)
    columns = 1 if max(map(len, labels)) > 40 else 2 if max(map(len, labels)) > 16 else 4
    legend = figure.legend(
        lines, blanks, title=title, loc="outside lower center", ncols=columns, frameon=False, handlelength=3.0
    )
    for text, label in zip(legend.get_texts(), labels, strict=True):
        text.set_text(as_it_is(label))


def bare(axes: Axes) -> None:
    """Take away the frame on top and on the right, and draw a faint grid."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(color="0.9", linewidth=0.6)
    axes.set_axisbelow(True)


def save(figure: Figure, folder: Path, name: str) -> None:
    """Write ``name.svg`` and ``name.png``, the same bytes for the same figure."""
    FigureCanvasAgg(figure)
    with any_signs():
        with rc_context({"svg.hashsalt": f"acoexp {name}"}):
            figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
        figure.savefig(folder / f"{name}.png", dpi=150)
