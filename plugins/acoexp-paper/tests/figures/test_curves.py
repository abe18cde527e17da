"""Convergence curves."""

from __future__ import annotations

import numpy as np
from acoexp_paper.figures.curves import draw_curves
from acoexp_paper.trials.experiment import Experiment

from acoexp.compare.curves import quartiles


def test_each_algorithm_has_a_panel_with_ten_trials_and_the_median_of_all(experiment: Experiment) -> None:
    samples = experiment.main["env2"]
    panels = draw_curves(samples).axes
    assert [axes.get_title() for axes in panels] == ["a. Standard ACO", "b. ACO-PD", "c. ACO-PDG"]
    for axes, algo in zip(panels, ("aco", "pd", "pdg"), strict=True):
        *trials, median, optimum = axes.lines
        np.testing.assert_array_equal([line.get_ydata() for line in trials], samples[algo].curves[:10])
        np.testing.assert_array_equal(median.get_ydata(), quartiles(samples[algo])[1])
        assert set(optimum.get_ydata()) == {samples[algo].optimum}
        assert median.get_xdata()[0] == 1


def test_the_ten_trials_stand_in_the_legend_once(experiment: Experiment) -> None:
    axes = draw_curves(experiment.main["env2"]).axes[0]
    assert axes.get_legend_handles_labels()[1].count("seeds 0 to 9") == 1
