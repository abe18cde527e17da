"""Pictures of all maps of an environment."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from acoexp_paper.figures.ensembles import draw_maps

from acoexp.registry.load_map import load_map


@pytest.mark.parametrize(("scored", "said"), [(True, "fig13\nno_cut, -12.3"), (False, "fig13\nno_cut")])
def test_each_map_stands_under_its_name_its_rule_and_its_score(scored: bool, said: str) -> None:
    grid = load_map("fig13", moves="no_cut")
    maps = [replace(grid, metadata={"score": "-12.34"})] * 9
    panels = draw_maps(maps, scored).axes
    assert [axes.get_title() for axes in panels if axes.get_visible()] == [said] * 9
    np.testing.assert_array_equal(panels[0].images[0].get_array() < 1, grid.obstacles)


def test_a_map_without_a_score_has_none() -> None:
    grid = replace(load_map("env2"), metadata={})
    assert draw_maps([grid], scored=True).axes[0].get_title() == f"env2\n{grid.moves}"
