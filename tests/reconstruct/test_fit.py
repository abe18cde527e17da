"""The fit of a map: what is counted of its trials, and the line for readers."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp.grid.moves import path_length
from acoexp.reconstruct.fit import Fit
from acoexp.reconstruct.likelihood import score
from acoexp.reconstruct.outcomes import Outcomes
from acoexp.reconstruct.published import ENVIRONMENTS, Pair

FIG13, ENV1 = ENVIRONMENTS["fig13"], ENVIRONMENTS["env1"]
ELSEWHERE: Pair = (20, 20)


def outcomes(*trials: tuple[int, int, Pair, Pair]) -> Outcomes:
    """Return trials given as x1, x3, and the moves of l1 and l2."""
    x1, x3, l1, l2 = zip(*trials, strict=True)
    lengths = (np.array([path_length(*pair) for pair in column]) for column in (l1, l2))
    return Outcomes(np.array(x1), np.array(x3), *lengths)


def test_each_published_length_is_counted_and_no_other() -> None:
    (local,) = FIG13.local_optima
    fit = Fit.of(FIG13, outcomes((5, 9, FIG13.optimum, local), (6, 6, local, local), (7, 7, ELSEWHERE, ELSEWHERE)))
    assert (fit.trials, fit.l1, fit.l2) == (3, {"30.3848": 1, "33.7990": 1}, {"30.3848": 0, "33.7990": 2})


def test_cycles_are_averaged() -> None:
    fit = Fit.of(ENV1, outcomes((4, 8, ENV1.optimum, ENV1.optimum), (7, 16, ELSEWHERE, ELSEWHERE)))
    assert (fit.x1, fit.x3) == (5.5, 12.0)


def test_its_score_is_that_by_which_the_search_judges() -> None:
    trials = outcomes((4, 8, ENV1.optimum, ENV1.optimum), (7, 16, ELSEWHERE, ELSEWHERE))
    assert Fit.of(ENV1, trials).score == score(ENV1, trials)


def test_what_is_published_stands_in_brackets() -> None:
    said = Fit.of(FIG13, outcomes(*[(4, 8, FIG13.optimum, FIG13.optimum)] * 4)).in_words(FIG13)
    assert said == (
        "standard ACO, 4 fresh trials (in brackets: published): 100% find 30.3848 (10 of 10), "
        "100% converge to 30.3848 (3 of 10), 0% converge to 33.7990 (7 of 10), mean x1 4.0 (11.0), x3 8.0 (28.1)"
    )


@pytest.mark.parametrize(("found", "share"), [(1, "25%"), (3, "75%")])
def test_where_no_trial_is_published_the_line_tells_how_many_find_the_optimum(found: int, share: str) -> None:
    trials = [(4, 8, ENV1.optimum, ELSEWHERE)] * found + [(4, 8, ELSEWHERE, ELSEWHERE)] * (4 - found)
    said = Fit.of(ENV1, outcomes(*trials)).in_words(ENV1)
    assert f"4 fresh trials: {share} find the optimum, 0% converge to it" in said
