"""The forest plot: a line for each map, named as long as names can be read, and what they say together."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure

from acoexp.compare.over_maps import forest
from acoexp.compare.over_maps.pooling import pooled


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """Return the figures that would be saved."""
    figures: list[Figure] = []
    monkeypatch.setattr(forest, "save", lambda figure, folder, name: figures.append(figure))
    return figures


def rows(maps: int, labels: str = "b") -> list[dict[str, Any]]:
    """Return effects of configurations against a."""
    draw = np.random.default_rng(maps)
    return [
        {"map": f"map-{number}", "a": label, "b": "a", "a12": effect, "low": effect - 0.1, "high": effect + 0.1}
        for label in labels
        for number, effect in enumerate(draw.uniform(0.2, 0.8, maps).tolist())
    ]


def labels_of(figure: Figure) -> list[str]:
    """Return the names beside the lines, from below."""
    return [label.get_text() for label in figure.axes[0].get_yticklabels()]


def test_each_map_has_its_effect_the_largest_on_top(drawn: list[Figure]) -> None:
    given = rows(7)
    forest.draw_forest(given, "ab", Path())
    (figure,) = drawn
    ordered = sorted(given, key=lambda row: row["a12"])
    assert labels_of(figure) == ["all maps", *(row["map"] for row in ordered)]
    points = next(line for line in figure.axes[0].lines if line.get_marker() == "s")
    assert points.get_xdata().tolist() == [row["a12"] for row in ordered]


def test_the_diamond_is_the_pooled_effect(drawn: list[Figure]) -> None:
    given = rows(7)
    forest.draw_forest(given, "ab", Path())
    (diamond,) = drawn[0].axes[0].patches
    mean = pooled(np.array([row["a12"] for row in given])).mean
    xs = diamond.get_path().vertices[:, 0]
    assert (xs.min(), xs.max()) == pytest.approx((mean.low, mean.high))


def test_few_maps_have_no_pooled_effect(drawn: list[Figure]) -> None:
    forest.draw_forest(rows(4), "ab", Path())
    assert "all maps" not in labels_of(drawn[0])
    assert len(drawn[0].axes[0].patches) == 0


def test_each_configuration_has_a_panel_with_the_same_maps(drawn: list[Figure]) -> None:
    forest.draw_forest(rows(6, "bc"), "abc", Path())
    assert [axes.get_title() for axes in drawn[0].axes] == ["b", "c"]


def test_hundreds_of_maps_are_drawn_without_names_on_a_page(drawn: list[Figure]) -> None:
    forest.draw_forest(rows(1000), "ab", Path())
    assert labels_of(drawn[0]) == ["all maps"]
    assert drawn[0].get_figheight() < 20
