"""Tables 1, 2 and 3 in the paper's own form, with our trials of the seeds 0 to 9."""

from __future__ import annotations

import numpy as np

from acoexp.report.measures import Sample
from acoexp.report.tables import Table
from acoexp_paper.averages import mean, values_of
from acoexp_paper.experiment import Experiment
from acoexp_paper.published import COLUMNS, ENVIRONMENTS, PERFORMANCE, TITLES, TRIALS


def trial_tables(experiment: Experiment) -> dict[str, Table]:
    """Return Tables 1, 2 and 3 by name."""
    return {
        "table1": _iterations(experiment, 1, "fig13"),
        "table2": _iterations(experiment, 2, "env2"),
        "table3": _performance(experiment),
    }


def _iterations(experiment: Experiment, number: int, env: str) -> Table:
    rows = []
    for algo in ("aco", "pd", "pdg"):
        sample = experiment.main[env][algo]
        columns = {name: values_of(sample, name)[:TRIALS] for name in COLUMNS}
        for trial in range(min(TRIALS, sample.found.size)):
            cells = [_shown(name, values[trial], 0) for name, values in columns.items()]
            rows.append([TITLES[algo] if trial == 0 else "", str(trial), *cells])
        rows.append(["Average result", "", *(_shown(name, mean(v), 1) for name, v in columns.items())])
    title = f"Table {number}. Comparison of the iteration times, path length for the three methods"
    note = (
        f"In the paper's form, on {_map_of(experiment, env)}. x1: cycle in which the best length l1 is first "
        "found; x2: that in which it is first found twice in a row; x3: that from which the curve stays at l2. "
        "Lengths in cells."
    )
    return Table(title, note, ["Algorithm", "Seed", *COLUMNS], rows)


def _performance(experiment: Experiment) -> Table:
    rows = []
    for algo in ("pf", "pdg"):
        cells = [_averaged(experiment.main[env][algo], name) for env in ("env1", "env2") for name in PERFORMANCE]
        rows.append([TITLES[algo], *cells])
    title = "Table 3. Comparison of the performance for the two methods"
    note = (
        f"In the paper's form, seeds 0 to {TRIALS - 1}, on {_map_of(experiment, 'env1')} and "
        f"{_map_of(experiment, 'env2')}. n_c: trials that found the optimum; l: mean length of convergence, in "
        "cells; n: mean cycle of finding, over those that did. ACO-PF is a reconstruction: its formulas are in "
        "no public source."
    )
    headings = [f"{env} {name}" for env in ("env1", "env2") for name in ("n_c", "l", "n")]
    return Table(title, note, ["Algorithm", *headings], rows)


def _averaged(sample: Sample, column: str) -> str:
    values = values_of(sample, column)[:TRIALS]
    return (
        str(int(values.sum())) if column == "n_c" else _shown("l2" if column == "l_bar" else "x1", mean(values), 1)
    )


def _map_of(experiment: Experiment, env: str) -> str:
    kind = "the map given for" if env in experiment.given else "our reconstruction of"
    return f"{kind} {ENVIRONMENTS[env].title}"


def _shown(column: str, value: float, digits: int) -> str:
    if np.isnan(value):
        return "-"
    return f"{value:.4f}" if column.startswith("l") else f"{value:.{digits}f}"
