"""Which trials are shown: of best paths, that which found the optimum."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from acoexp_paper.figures import single
from acoexp_paper.trials.experiment import Experiment
from made import sample


@pytest.mark.parametrize(
    ("lengths", "seed"), [([12.0, 10.0, 10.0], 1), ([12.0, 11.0, np.nan], 1), ([np.nan, np.nan, 15.0], 2)]
)
def test_the_best_run_is_the_first_with_the_shortest_path(
    experiment: Experiment, monkeypatch: pytest.MonkeyPatch, lengths: list[float], seed: int
) -> None:
    class Solver:
        def __init__(self, *_: object) -> None: ...

        def solve(self, seed: int) -> SimpleNamespace:
            return SimpleNamespace(seed=seed)

    monkeypatch.setattr(single, "Solver", Solver)
    main = {"fig13": {"pdg": replace(sample(), features={"l1": np.array(lengths)})}}
    asked = SimpleNamespace(main=main, maps=experiment.maps, settings=experiment.settings)
    assert single.best_run(asked, "fig13").seed == seed
