"""What diffusion does to lost ants, iterations and lengths."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from acoexp_paper.figures.effects import draw_iterations, draw_lengths, draw_lost
from acoexp_paper.trials.experiment import Experiment
from made import sample

ALGOS = ("aco", "pd", "pdg")
TITLES = ["Standard ACO", "ACO-PD", "ACO-PDG"]


def test_lost_ants_are_drawn_from_the_first_cycle_on(experiment: Experiment) -> None:
    lost = experiment.lost_per_cycle("fig13")
    (axes,) = draw_lost(lost, ants=5).axes
    assert [line.get_label() for line in axes.lines] == TITLES
    for line, algo in zip(axes.lines, ALGOS, strict=True):
        assert line.get_xdata()[0] == 1
        np.testing.assert_array_equal(line.get_ydata(), lost[algo])
    assert axes.get_ylim()[0] == 0
    assert "of 5" in axes.get_ylabel()


def test_by_each_cycle_so_many_trials_have_found_the_optimum() -> None:
    rare = replace(sample(5), found=np.arange(400) < 100)
    (axes,) = draw_iterations({"aco": rare, "pd": sample(5), "pdg": sample(9)}, 1).axes
    shares = [np.asarray(line.get_ydata()) for line in axes.lines[::2]]
    assert shares[0][-1] == 0.25
    assert shares[1][2 - 1] == 0.0
    assert shares[1][5 - 1] == (sample(5).features["x1"] <= 5).mean()
    assert shares[1][7 - 1] == shares[2][-1] == 1.0


def test_the_published_trials_stand_beside_ours_as_they_find_the_optimum() -> None:
    found = {"aco": replace(sample(5), optimum=35.07107), "pd": sample(5), "pdg": sample(9)}
    (axes,) = draw_iterations(found, 2).axes
    assert axes.lines[1].get_label() == "Standard ACO, published"
    np.testing.assert_allclose(axes.lines[1].get_data(), [[2, 5, 5, 5, 6], [0.1, 0.2, 0.3, 0.4, 0.5]])


def test_trials_are_counted_by_the_length_that_they_converge_to() -> None:
    lengths = {"aco": [10.0, 11.0], "pd": [12.0, np.nan], "pdg": [10.0, 10.0]}
    samples = {algo: _converged(np.repeat(values, 200)) for algo, values in lengths.items()}
    (axes,) = draw_lengths(samples, 1).axes
    shown = ["10.0000", "11.0000", "12.0000", "30.3848", "33.7990", "others"]
    assert [text.get_text() for text in axes.get_xticklabels()] == shown
    heights = {bars.get_label(): [bar.get_height() for bar in bars] for bars in axes.containers}
    counted = [[0.5, 0.5, 0, 0, 0, 0], [0, 0, 0.5, 0, 0, 0.5], [1, 0, 0, 0, 0, 0]]
    assert heights == dict(zip(TITLES, counted, strict=True))
    np.testing.assert_array_equal(axes.lines[0].get_ydata(), [np.nan, np.nan, np.nan, 0.3, 0.7])


def test_the_optimum_stands_first_though_none_converges_to_it_and_rare_lengths_stand_together() -> None:
    many = _converged(np.concatenate([np.arange(20.0, 29.0), np.repeat(np.arange(20.0, 27.0), 10)]))
    (axes,) = draw_lengths(dict.fromkeys(ALGOS, many), 1).axes
    shown = [text.get_text() for text in axes.get_xticklabels()]
    lengths = [*(f"{length:.4f}" for length in range(20, 27)), "30.3848", "33.7990"]
    assert shown == ["10.0000", *lengths, "others"]
    assert axes.containers[0][-1].get_height() == pytest.approx(2 / 79)


def _converged(l2: np.ndarray) -> object:
    some = sample()
    return replace(some, found=np.full(l2.size, True), features={**some.features, "l2": l2})
