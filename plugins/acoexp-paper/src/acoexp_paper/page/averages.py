"""The sections of averages: Tables 1 to 3 with our trials in the paper's form, and each average beside ours."""

from __future__ import annotations

from acoexp.compare.sample import Sample
from acoexp.report.table import Table
from acoexp_paper.claims.averages import Average
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.means import mean
from acoexp_paper.page.document import Block, Numbers
from acoexp_paper.page.formats import estimate, number, yes_or_no
from acoexp_paper.published.tables import (
    ALGOS,
    COLUMNS,
    ENVIRONMENTS,
    TABLE_3,
    TABLES,
    TITLES,
    TRIALS,
    average,
    column,
    performance,
)
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.samples import values_of


def trial_tables(experiment: Experiment) -> list[Block]:
    """Return Tables 1, 2 and 3, with our trials of the seeds 0 to 9 beside those that are published."""
    tables = [_iterations(experiment, table, env) for table, env in TABLES.items()] + [_performance(experiment)]
    return [Numbers(f"table{number}", table) for number, table in enumerate(tables, 1)]


def _iterations(experiment: Experiment, table: int, env: str) -> Table:
    rows = [row for algo in ALGOS for row in _rows(table, algo, experiment.main[env][algo])]
    title = f"Table {table}. Comparison of the iteration times, path length for the three methods."
    note = (
        f"Left our trials, seeds 0 to {TRIALS - 1}, on {_map_of(experiment, env)}, right the paper's as printed; "
        "trials in one row have nothing in common but their number. x1: cycle in which the best length l1 is "
        "first found; x2: that in which it is first found twice in a row; x3: that from which the curve stays "
        "at l2. Lengths in cells."
    )
    headings = ["Algorithm", "Trial", *(f"ours {name}" for name in COLUMNS)]
    return Table(title, note, [*headings, *(f"paper {name}" for name in COLUMNS)], rows)


def _rows(table: int, algo: str, sample: Sample) -> list[list[str]]:
    ours = {name: values_of(sample, name)[:TRIALS] for name in COLUMNS}
    papers = {name: column(table, algo, name) for name in COLUMNS}
    rows = [
        [
            "" if trial else TITLES[algo], str(trial + 1),
            *(number(name, values[trial], 0) for columns in (ours, papers) for name, values in columns.items()),
        ]
        for trial in range(min(TRIALS, sample.found.size))
    ]  # fmt: skip
    means = [number(name, mean(values)) for name, values in ours.items()]
    return [*rows, ["Average result", "", *means, *(number(n, average(table, algo, n)) for n in COLUMNS)]]


def _performance(experiment: Experiment) -> Table:
    rows = []
    for algo in TABLE_3.algos:
        where = [(env, name) for env in TABLE_3.environments for name in TABLE_3.columns]
        ours = [_of_ten(experiment.main[env][algo], name) for env, name in where]
        papers = [number(name, performance(env, algo, name), 0 if name == "n_c" else 1) for env, name in where]
        rows += [[TITLES[algo], "ours", *ours], ["", "paper", *papers]]
    note = (
        f"Ours: seeds 0 to {TRIALS - 1}, on {_map_of(experiment, 'env1')} and "
        f"{_map_of(experiment, 'env2')}; paper: as printed. n_c: trials that found the optimum; l: mean length of "
        "convergence, in cells; n: mean cycle of finding, over those that did (- if none did). ACO-PF is a "
        "reconstruction: its formulas are in no public source."
    )
    headings = [f"{env} {name}" for env in TABLE_3.environments for name in ("n_c", "l", "n")]
    title = "Table 3. Comparison of the performance for the two methods."
    return Table(title, note, ["Algorithm", "trials", *headings], rows)


def _of_ten(sample: Sample, column: str) -> str:
    values = values_of(sample, column)[:TRIALS]
    return str(int(values.sum())) if column == "n_c" else number(column, mean(values))


def _map_of(experiment: Experiment, env: str) -> str:
    kind = "the map given for" if env in experiment.given else "our reconstruction of"
    return f"{kind} {ENVIRONMENTS[env].title}"


def averages(found: Findings) -> list[Block]:
    """Return every published average beside ours."""
    note = (
        "Published averages, of ten trials each, beside ours: of the seeds 0 to 9, and of all "
        f"{found.experiment.trials} trials on the environment's own map with the interval in which the mean of "
        "ten trials falls in 95 % of cases. Inside: whether the published average lies in it. Over the maps: "
        "the same where the map, too, is drawn from all of the environment's. x2_last is x2 read as the last "
        "cycle with l1 where l2 differs. Lengths in cells, n_c of ten; l_bar, n_bar: l and n of Table 3. *: the "
        "maps were fitted to it."
    )
    headings = ["table", "map", "algorithm", "column", "published", "seeds 0-9", "ours", "inside"]
    headings += ["over the maps", "inside (maps)"]
    rows = [_average(row) for row in found.averages]
    return [Numbers("averages", Table("Averages, published and ours.", note, headings, rows))]


def _average(row: Average) -> list[str]:
    table, env, algo, column, published = row.printed
    return [
        str(table), env, TITLES[algo], column + (" *" if row.printed.fitted else ""), number(column, published),
        number(column, row.first_ten), estimate(column, row.ours), yes_or_no(row.inside),
        "-" if row.over_maps is None else estimate(column, row.over_maps), yes_or_no(row.inside_over_maps),
    ]  # fmt: skip
