"""The table at the end: what its figures are, and that none is ever cut off."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from acoexp.command.results import table


def trial(seed: int, **changes: Any) -> dict[str, Any]:
    """Return a trial as its record has it, with made-up figures."""
    return {
        "algo": "pdg", "map": "env2", "seed": seed, "configuration_id": "c", "seconds": 0.002,
        "x1": 5, "x2": 6, "x3": 7, "l1": 11.0, "l2": 12.0, "l1_pair": [11, 0],
        "optimum": 10.0, "optimum_pair": [10, 0], "lost_ants": [1, 0, 1],
        "config": {"algo": "pdg", "map.name": "env2", "seed": str(seed), "rho": "0.5"},
    } | changes  # fmt: skip


def config(**changes: str) -> dict[str, Any]:
    """Return what makes a trial one of another configuration."""
    base = {"algo": "pdg", "map.name": "env2", "rho": "0.5"}
    return {
        "config": base | changes,
        "configuration_id": json.dumps(changes),
        **({"algo": changes.get("algo", "pdg")}),
    }


def table_of(folder: Path, trials: list[dict[str, Any]], capsys: pytest.CaptureFixture[str]) -> list[list[str]]:
    """Print a sweep of these trials and return the words of each line."""
    table.print_sweep(trials, folder, where="nowhere", ended="all is done")
    return [line.split() for line in capsys.readouterr().out.splitlines()]


def row(lines: list[list[str]], number: int = 1) -> dict[str, str]:
    """Return one row by its headings."""
    return dict(zip(lines[0], [word for word in lines[number] if word != "%"], strict=True))


def test_a_row_holds_means_with_the_samples_deviation_below(tmp_path: Path, capsys: Any) -> None:
    lines = table_of(tmp_path, [trial(0, l1=10.0, l1_pair=[10, 0], x1=4), trial(1, l1=12.0, x1=8)], capsys)
    means = row(lines)
    assert (means["x1"], means["l1"], means["optimum"], means["gap"]) == ("6.0", "11.0000", "10.0000", "10.00")
    assert (means["lost"], means["found"], means["ms"]) == ("2.0", "1/2", "2.0")
    assert lines[2][0] == "±2.8"  # the square root of 8
    assert "±1.41" in lines[2]


def test_undefined_figures_stay_out_of_the_mean(tmp_path: Path, capsys: Any) -> None:
    nothing = {"x1": 0, "x2": 0, "x3": 0, "l1": None, "l2": None, "l1_pair": None}
    means = row(table_of(tmp_path, [trial(0), trial(1, **nothing)], capsys))
    assert (means["x1"], means["l1"], means["found"]) == ("5.0", "11.0000", "0/2")


def test_what_no_trial_has_is_a_dash(tmp_path: Path, capsys: Any) -> None:
    means = row(table_of(tmp_path, [trial(0, x3=0, l2=None)], capsys))
    assert (means["x3"], means["l2"]) == ("-", "-")


def test_each_algorithm_and_map_has_a_row(tmp_path: Path, capsys: Any) -> None:
    trials = [trial(s, **config(algo=algo)) for algo in ("pdg", "aco") for s in (1, 0)]
    lines = table_of(tmp_path, trials, capsys)
    assert [line[0] for line in lines if line[1:2] == ["env2"]] == ["aco", "pdg"]
    assert "rho" not in lines[0]


def test_rows_of_a_scenario_are_told_apart_by_their_names(tmp_path: Path, capsys: Any) -> None:
    sweep = [("nav", "0.5"), ("acs", "0.1")]
    trials = [
        trial(
            0,
            **config(algo=algo, rho=rho, **{"map.name": "movingai", "map.instance": str(n)}),
            map=f"yard.map#{n}",
        )
        for algo, rho in sweep
        for n in (0, 1)
    ]
    lines = table_of(tmp_path, trials, capsys)
    assert lines[0][:3] == ["algo", "map", "x1"]
    named = [line[:2] for line in lines if line[1:2] and line[1].startswith("yard")]
    assert named == [[algo, f"yard.map#{n}"] for n in (0, 1) for algo in ("acs", "nav")]


def test_a_key_that_tells_rows_apart_has_a_column(tmp_path: Path, capsys: Any) -> None:
    lines = table_of(tmp_path, [trial(0, **config(rho=rho)) for rho in ("0.3", "0.5")], capsys)
    assert [row(lines, n)["rho"] for n in (1, 2)] == ["0.3", "0.5"]


def test_nothing_is_cut_off_where_the_output_is_no_terminal(tmp_path: Path, capsys: Any) -> None:
    keys = {f"diffusion.parameter_{n}": "0.123456" for n in range(9)}
    others = dict.fromkeys(keys, "0.654321")
    lines = table_of(tmp_path, [trial(0, **config(**keys)), trial(1, **config(**others))], capsys)
    assert set(keys) <= set(lines[0])
    assert not any("…" in word for line in lines for word in line)


def test_the_end_says_how_it_ended_and_where_everything_lies(tmp_path: Path, capsys: Any) -> None:
    lines = table_of(tmp_path, [trial(0), trial(1)], capsys)
    assert lines[-3] == ["all", "is", "done"]
    assert lines[-2] == ["files:", str(tmp_path)]
    assert lines[-1] == ["runs:", "nowhere"]


def test_of_a_trial_alone_what_is_not_done_yet_is_not_said_to_be(tmp_path: Path, capsys: Any) -> None:
    (tmp_path / "trial.json").write_text(json.dumps(trial(0)), encoding="utf-8")
    table.print_trial(tmp_path, Path("outputs/here"))
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == ["algo", "pdg", "files:", "pictures"]
    assert lines[2:] == ["files: outputs/here", "pictures follow, then where it is kept"]
    table.print_run("in [a] store")
    assert capsys.readouterr().out == "run:   in [a] store\n"


def test_a_sweep_without_a_finished_trial_has_no_table(tmp_path: Path, capsys: Any) -> None:
    assert table_of(tmp_path, [], capsys)[0] == ["all", "is", "done"]


@pytest.mark.parametrize(
    ("settings", "advice"),
    [
        ({"dead_end": "lost"}, "; algo=nav steps back from dead ends"),
        ({"dead_end": "step_back", "max_steps": "None"}, ""),
        ({"dead_end": "step_back", "max_steps": "9"}, "; max_steps=null lets them go on"),
    ],
)
def test_where_no_ant_ever_arrived_it_says_why_and_what_helps(
    settings: dict[str, str], advice: str, tmp_path: Path, capsys: Any
) -> None:
    lost = {"x1": 0, "x2": 0, "x3": 0, "l1": None, "l2": None, "l1_pair": None, **config(**settings)}
    trials = [trial(0, **config(**settings)), *(trial(s, **lost, lost_after=s) for s in (200, 230))]
    lines = [" ".join(line) for line in table_of(tmp_path, trials, capsys)]
    assert lines[-5] == "in 2 of 3 trials no ant ever reached the goal: all were lost on the way"
    assert lines[-4] == (
        f"pdg on env2: they were lost after 215 moves on average, and the goal is 10 cells away{advice}"
    )
