"""The pictures over maps, each with what it shows; those that would show nothing are left out."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from acoexp.compare.over_maps.budgets import TARGETS, Anytime
from acoexp.compare.over_maps.values import CLOSE, MapValues
from acoexp.compare.over_maps.verdict import Verdict
from acoexp.compare.page import Picture
from acoexp.compare.sample import Row


def draw_over_maps(
    folder: Path,
    values: MapValues,
    verdict: Verdict,
    effects: Sequence[Row],
    reached: Sequence[Sequence[Anytime]],
) -> list[Picture]:
    """Draw all that there is to be shown, and return it in the order of the page.

    Args:
        folder: Where the pictures go.
        values: What each configuration is worth on each map.
        verdict: The verdict on it.
        effects: A row for each map of each configuration beside the first.
        reached: What each configuration reaches within budgets, by their unit.
    """
    from acoexp.compare.over_maps.diagram import draw_diagram  # matplotlib takes its time to import
    from acoexp.compare.over_maps.forest import draw_forest
    from acoexp.compare.over_maps.pictures import draw_budgets, draw_profiles, draw_targets

    pictures: list[Picture] = []
    if verdict.difference is not None:
        draw_diagram(verdict, values.configurations, folder)
        pictures.append(DIAGRAM)
    if len(values.maps) > 1:
        draw_forest(effects, values.configurations, folder)
        draw_profiles(values, folder)
        pictures += [FOREST, PROFILES]
    draw_targets(reached, folder)
    draw_budgets(reached, folder)
    return [*pictures, HIT, LEFT]


DIAGRAM = Picture(
    "Critical-difference diagram",
    "Mean ranks over maps (Demsar 2006). A bar joins configurations that are not told apart: their mean ranks "
    "differ by no more than Nemenyi's critical difference at 5 %, or Friedman's test tells none of them apart.",
    "ranks",
)
FOREST = Picture(
    "Effects map by map",
    "A12 of the best paths' lengths against the first configuration, above 0.5 where the path is shorter: on "
    "each map with its bootstrap interval over seeds. The diamond is the mean over maps with its interval, "
    "the line behind it where the next map's effect is to be expected; five maps or more have them. All "
    "intervals are at 95 %.",
    "effects",
)
PROFILES = Picture(
    "Performance profiles",
    "Share of maps on which a configuration is within a factor of the best one there (Dolan, More 2002). "
    "Left: the median length of the trials' best paths. Right: ant steps spent by all trials per trial that "
    f"came within {100 * CLOSE:g} % of the optimum. A curve that ends below 100 % has maps without such a trial.",
    "profiles",
)
HIT = Picture(
    "Targets hit within a budget",
    f"The share of trials and targets that are hit, {len(TARGETS)} targets from twice the optimum to the optimum "
    "itself ("
    + ", ".join(f"{100 * target:g} %" for target in TARGETS[::-1])
    + " longer): the mean over maps, each "
    "of which counts alike, and its bootstrap interval over five maps or more.",
    "targets",
)
LEFT = Picture(
    "Gap left after a budget",
    "By how much the best path so far is longer than the optimum: the median over seeds on each map; of those the "
    "median and quartiles over maps. A line begins where half of the maps have a path.",
    "budgets",
)
