"""The critical-difference diagram: each name at its rank, a bar over what is not told apart."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from acoexp.compare.over_maps import diagram
from acoexp.compare.over_maps.ranking import Friedman
from acoexp.compare.over_maps.verdict import Verdict

TOLD, NOT_TOLD = Friedman(9.28, 0.026, 3.69, 0.02), Friedman(1.0, 0.8, 0.3, 0.8)


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """Return the figures that would be saved."""
    figures: list[Figure] = []
    monkeypatch.setattr(diagram, "save", lambda figure, folder, name: figures.append(figure))
    return figures


def axes_of(drawn: list[Figure], ranks: list[float], difference: float, test: Friedman = TOLD) -> Axes:
    """Return the diagram of configurations A, B ... with such mean ranks."""
    verdict = Verdict("", [], [], np.array(ranks), test, difference)
    diagram.draw_diagram(verdict, [chr(ord("A") + place) for place in range(len(ranks))], Path())
    (axes,) = drawn.pop().axes
    return axes


def bars(axes: Axes) -> list[tuple[float, float]]:
    """Return where bars begin and end."""
    return [tuple(line.get_xdata()) for line in axes.lines if line.get_linewidth() == 4]


def test_the_published_example_has_the_published_bars(drawn: list[Figure]) -> None:
    """Demsar 2006, Fig. 1 (a): with a critical difference of 1.25 all four hang together."""
    axes = axes_of(drawn, [3.143, 2.000, 2.893, 1.964], 1.25)
    assert bars(axes) == [(1.964, 3.143)]
    assert "critical difference 1.25" in " ".join(text.get_text() for text in axes.texts)


def test_groups_that_overlap_have_a_bar_each_at_heights_of_their_own(drawn: list[Figure]) -> None:
    axes = axes_of(drawn, [1.2, 2.0, 2.8, 4.0], 1.0)
    assert bars(axes) == [(1.2, 2.0), (2.0, 2.8)]
    assert len({line.get_ydata()[0] for line in axes.lines if line.get_linewidth() == 4}) == 2


def test_where_nothing_is_told_apart_one_bar_joins_all(drawn: list[Figure]) -> None:
    assert bars(axes_of(drawn, [1.0, 3.0, 2.0], 0.5, NOT_TOLD)) == [(1.0, 3.0)]


def test_names_stand_with_their_ranks_the_better_half_on_the_left(drawn: list[Figure]) -> None:
    axes = axes_of(drawn, [3.0, 1.25, 2.0, 4.0, 4.75], 0.1)
    names = [(text.get_text(), text.get_ha()) for text in axes.texts if text.get_ha() != "center"]
    assert {*names} >= {("B  1.25", "right"), ("C  2.00", "right"), ("A  3.00", "right"), ("4.75  E", "left")}
    marks = [line.get_xdata()[0] for line in axes.lines if line.get_marker() == "o"]
    assert sorted(marks) == [1.25, 2.0, 3.0, 4.0, 4.75]


def test_names_do_not_lie_on_each_other(drawn: list[Figure]) -> None:
    axes = axes_of(drawn, [3.01, 3.02, 3.03, 3.04, 3.05, 3.06, 3.07], 0.1)
    for side in ("left", "right"):
        heights = sorted(text.get_position()[1] for text in axes.texts if text.get_ha() == side and "  " in
                         text.get_text() and "critical" not in text.get_text())  # fmt: skip
        assert np.diff(heights).min() > 0.5
