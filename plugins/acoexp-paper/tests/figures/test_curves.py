"""Convergence curves."""

from __future__ import annotations

import numpy as np
from acoexp_paper.figures.curves import draw_curves
from acoexp_paper.published.tables import mended
from acoexp_paper.trials.experiment import Experiment

from acoexp.compare.curves import quartiles


def test_each_algorithm_has_a_panel_with_ten_trials_and_the_median_of_all(experiment: Experiment) -> None:
    samples = experiment.main["env2"]
    panels = draw_curves(samples, 2).axes
    assert [axes.get_title() for axes in panels] == ["a. Standard ACO", "b. ACO-PD", "c. ACO-PDG"]
    for axes, algo in zip(panels, ("aco", "pd", "pdg"), strict=True):
        *trials, median, optimum, best, settled = axes.lines
        np.testing.assert_array_equal([line.get_ydata() for line in trials], samples[algo].curves[:10])
        np.testing.assert_array_equal(median.get_ydata(), quartiles(samples[algo])[1])
        assert set(optimum.get_ydata()) == {samples[algo].optimum}
        assert median.get_xdata()[0] == 1
        np.testing.assert_array_equal(best.get_data(), [mended(2, algo, name) for name in ("x1", "l1")])
        np.testing.assert_array_equal(settled.get_xdata(), mended(2, algo, "x3"))


def test_the_ten_trials_stand_in_the_legend_once(experiment: Experiment) -> None:
    axes = draw_curves(experiment.main["env2"], 2).axes[0]
    assert axes.get_legend_handles_labels()[1].count("seeds 0 to 9") == 1


def test_a_published_length_far_above_all_of_ours_stands_at_the_top_with_its_number(
    experiment: Experiment,
) -> None:
    axes = draw_curves(experiment.main["env2"], 2).axes[1]
    assert [text.get_text() for text in axes.texts] == ["63.3137"]
    assert axes.lines[-1].get_ydata().max() <= axes.get_ylim()[1] < 63
