"""What pictures share: lines that can be told apart, names as they are, the same bytes for the same figure."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest
from matplotlib.figure import Figure

from acoexp.compare.drawing import add_legend, look, save


def test_lines_differ_in_colour_and_dashes_as_long_as_there_are_any() -> None:
    looks = [tuple(look(place).values()) for place in range(28)]
    assert len(set(looks)) == 28
    assert all(a[0] != b[0] and a[1] != b[1] for a, b in pairwise(looks))


@pytest.mark.parametrize("labels", [["_a", "$b$"], ["a" * 30, "b"], ["a" * 60, "b"]])
def test_a_legend_has_each_name_as_it_is(labels: list[str], tmp_path: Path) -> None:
    figure = Figure(layout="constrained")
    axes = figure.subplots()
    lines = [axes.plot([1, 2], **look(place))[0] for place in range(2)]
    add_legend(figure, lines, labels, "both")
    save(figure, tmp_path, "one")
    svg = (tmp_path / "one.svg").read_text("utf-8")
    assert [svg.count(f"<!-- {label} -->") for label in labels] == [1, 1]
    assert (tmp_path / "one.png").stat().st_size > 1000


def test_the_same_figure_has_the_same_bytes(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        figure = Figure()
        figure.subplots().plot([1, 2, 3])
        save(figure, tmp_path / name, "one")
    for ending in ("svg", "png"):
        assert (tmp_path / "a" / f"one.{ending}").read_bytes() == (tmp_path / "b" / f"one.{ending}").read_bytes()
