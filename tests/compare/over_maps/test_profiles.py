"""Performance profiles against their definition, counted map by map."""

from __future__ import annotations

import numpy as np

from acoexp.compare.over_maps.profiles import profile, ratios_to_best

COSTS = np.array([[2.0, 4.0, np.inf], [3.0, 3.0, 9.0], [np.inf, np.inf, np.inf], [8.0, 2.0, 2.5]])


def test_ratios_are_to_the_best_on_each_map_and_infinite_without_a_value() -> None:
    inf = np.inf
    assert ratios_to_best(COSTS).tolist() == [[1, 2, inf], [1, 1, 3], [inf, inf, inf], [4, 1, 1.25]]


def test_a_profile_is_the_share_of_all_maps_within_a_factor() -> None:
    ratios, factors = ratios_to_best(COSTS), np.array([1.0, 1.25, 1.9, 2.0, 3.0, 4.0, 100.0])
    for column in ratios.T:
        counted = [sum(ratio <= factor for ratio in column) / len(column) for factor in factors]
        assert profile(column, factors).tolist() == counted
