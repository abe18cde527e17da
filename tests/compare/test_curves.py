"""Convergence curves: lost cycles rank behind all others, and the same trials give the same picture."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from acoexp.compare.curves import draw_curves, quartiles
from acoexp.compare.sample import Sample


def sample(curves: list[list[float]], configuration: str = "c", name: str = "yard") -> Sample:
    """Return trials with such curves."""
    steps = np.ones((len(curves), len(curves[0])), dtype=np.int64)
    return Sample(configuration, name, 7.0, np.zeros(len(curves), dtype=bool), {}, np.array(curves), steps)


def test_quartiles_rank_lost_cycles_behind() -> None:
    lost = np.nan
    found = quartiles(sample([[9.0, 7.0], [lost, 7.0], [8.0, lost], [lost, lost]]))
    assert np.array_equal(found, [[8.0, 7.0], [9.0, 7.0], [np.nan, np.nan]], equal_nan=True)


def test_quartiles_are_lengths_that_a_trial_had() -> None:
    assert quartiles(sample([[1.0], [2.0], [4.0], [8.0]])).tolist() == [[1.0], [2.0], [4.0]]


SAMPLES = [
    sample([[9.0, 8.0, 7.0], [9.0, 7.0, 7.0]], configuration, name)
    for name in ("yard", "garden")
    for configuration in ("mine", "theirs")
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the curves of two configurations on two maps."""
    folder = tmp_path_factory.mktemp("curves")
    draw_curves(SAMPLES, folder)
    return folder


def test_the_same_trials_give_the_same_bytes(folder: Path, tmp_path: Path) -> None:
    draw_curves(SAMPLES, tmp_path)
    for name in ("curves.svg", "curves.png"):
        assert (tmp_path / name).read_bytes() == (folder / name).read_bytes()


def test_each_map_has_a_panel_and_each_configuration_a_line_in_the_legend(folder: Path) -> None:
    svg = (folder / "curves.svg").read_text("utf-8")
    assert len(re.findall(r'<g id="axes_\d+">', svg)) == 2
    for text in ("mine", "theirs", "exact optimum", "yard, optimum 7.0000", "garden, optimum 7.0000"):
        assert svg.count(f"<!-- {text} -->") == 1, text


def test_a_picture_of_more_maps_is_higher(folder: Path, tmp_path: Path) -> None:
    draw_curves(SAMPLES[:2], tmp_path)
    with Image.open(folder / "curves.png") as two, Image.open(tmp_path / "curves.png") as one:
        assert two.width == one.width
        assert two.height > one.height


def test_a_map_on_which_all_ants_are_lost_has_a_panel(tmp_path: Path) -> None:
    draw_curves([sample([[np.nan, np.nan]], name) for name in ("mine", "theirs")], tmp_path)
    assert "<!-- yard, optimum 7.0000 -->" in (tmp_path / "curves.svg").read_text("utf-8")
