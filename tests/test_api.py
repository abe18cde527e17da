"""``solve`` and ``solve_many``: what a map may be, and that Python needs neither Hydra nor MLflow."""

from __future__ import annotations

import inspect
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import acoexp
from acoexp import Grid, MapError, SettingsError, solve, solve_many

FAST: dict[str, Any] = {"ants": 2, "iterations": 2}
"""Settings for a trial that costs next to nothing, compiled or not."""
YARD = np.array([[0, 1, 0], [0, 0, 0]])


def test_a_map_may_be_a_name() -> None:
    result = solve("fig13", algo="aco", seed=0, **FAST)
    assert (result.grid.name, result.grid.shape) == ("fig13", (20, 20))


def test_a_map_may_be_loaded_as_the_command_line_does(tmp_path: Path) -> None:
    (tmp_path / "yard.txt").write_text("010\n000\n")
    grid = acoexp.load_map("file", path=str(tmp_path / "yard.txt"), start=(1, 0), goal=(0, 2), moves="no_cut")
    assert grid.digest == Grid(YARD, start=(1, 0), goal=(0, 2), moves="no_cut").digest
    assert solve(grid, algo="aco", **FAST).grid is grid


def test_a_map_may_be_a_grid() -> None:
    grid = Grid(YARD, goal=(0, 2), moves="no_cut")
    assert solve(grid, algo="aco", **FAST).grid is grid


@pytest.mark.parametrize("array", [YARD, YARD.astype(bool), YARD.tolist()])
def test_a_map_may_be_an_array_from_corner_to_corner(array: Any) -> None:
    grid = solve(array, algo="aco", **FAST).grid
    assert (grid.start, grid.goal, grid.moves) == ((0, 0), (1, 2), "no_squeeze")


def test_with_an_array_ends_and_rule_may_be_given() -> None:
    grid = solve(YARD, algo="aco", start=(1, 0), goal=(0, 2), moves="no_cut", **FAST).grid
    assert (grid.start, grid.goal, grid.moves) == ((1, 0), (0, 2), "no_cut")
    assert grid.optimum_pair == (3, 0)


@pytest.mark.parametrize("option", [{"start": (0, 0)}, {"goal": (1, 2)}, {"moves": "free"}])
@pytest.mark.parametrize("map", ["fig13", Grid(YARD)])
def test_a_map_of_its_own_has_ends_and_rule_of_its_own(map: Any, option: dict[str, Any]) -> None:
    with pytest.raises(SettingsError, match=r"start, goal and moves: expected only with a map given as an array"):
        solve(map, **option)


def test_an_unknown_map_is_refused_with_those_that_are_known() -> None:
    with pytest.raises(SettingsError, match=r"map: expected one of: env1, env2, fig13, file.*; got 'fig12'"):
        solve("fig12")


def test_a_map_from_a_file_needs_its_path() -> None:
    with pytest.raises(SettingsError, match=r"map.path: expected a text; got nothing"):
        solve("file")


@pytest.mark.parametrize("odd", [None, 5, [], "…", [[0, 2]], [["fig13"]], np.zeros((2, 2, 2))])
def test_what_is_no_map_is_refused(odd: Any) -> None:
    with pytest.raises((MapError, SettingsError), match=r"^map"):
        solve(odd)


@pytest.mark.parametrize("moves", ["", "sideways"])
def test_with_an_array_an_unknown_rule_is_refused(moves: str) -> None:
    with pytest.raises(MapError, match=r"expected one of: free, no_squeeze, no_cut, four"):
        solve(YARD, moves=moves)


def test_settings_are_checked_before_anything_runs() -> None:
    for wrong in ({"ants": 0}, {"algo": "pgd"}, {"diffusion": "gausian"}, {"gama": 1}, {"seed": -1}):
        with pytest.raises(SettingsError):
            solve(YARD, **wrong)


def test_the_defaults_are_pdg_and_seed_0() -> None:
    default, said = solve(YARD, **FAST), solve(YARD, algo="pdg", seed=0, **FAST)
    assert (default.algo, default.seed) == ("pdg", 0)
    assert default.curve_pairs.tolist() == said.curve_pairs.tolist()


def test_the_same_seed_gives_the_same_result() -> None:
    first, again, other = (solve("fig13", algo="aco", seed=seed, **FAST) for seed in (7, 7, 8))
    assert first.curve_pairs.tolist() == again.curve_pairs.tolist()
    assert first.ant_steps == again.ant_steps
    assert first.ant_steps != other.ant_steps


@pytest.mark.parametrize("threads", [None, 1, 3])
def test_many_trials_are_each_seeds_own_in_the_order_of_the_seeds(threads: int | None) -> None:
    seeds = [5, 3, 5, 0]
    many = solve_many("fig13", "aco", seeds, threads=threads, **FAST)
    alone = [solve("fig13", "aco", seed, **FAST) for seed in seeds]
    assert [result.seed for result in many] == seeds
    assert [result.curve_pairs.tolist() for result in many] == [result.curve_pairs.tolist() for result in alone]


def test_seeds_may_be_anything_to_go_through_once() -> None:
    assert [r.seed for r in solve_many(YARD, "aco", (s for s in (1, 2)), **FAST)] == [1, 2]
    assert [r.seed for r in solve_many(YARD, "aco", np.arange(2), **FAST)] == [0, 1]
    assert solve_many(YARD, "aco", [], **FAST) == []


@pytest.mark.parametrize("seeds", [5, None, [0, -1], "01", [0.5]])
def test_other_seeds_are_refused(seeds: Any) -> None:
    with pytest.raises(SettingsError, match=r"seed"):
        solve_many(YARD, "aco", seeds, **FAST)


@pytest.mark.parametrize("threads", [0, -1, 1.5, True, "2"])
def test_threads_are_counted(threads: Any) -> None:
    with pytest.raises(SettingsError, match=r"threads: expected a whole number from 1 to 4096; got "):
        solve_many(YARD, "aco", [0], threads=threads, **FAST)


def test_the_label_tells_a_preset_from_what_was_put_together() -> None:
    assert solve(YARD, algo="pd", diffusion={"gamma": 0.5}, **FAST).algo == "pd"
    assert solve(YARD, algo="pd", diffusion="none", **FAST).algo == "custom"


def test_python_loads_neither_hydra_nor_mlflow_nor_matplotlib() -> None:
    program = """
import sys
import acoexp
acoexp.solve_many([[0, 0], [0, 0]], algo="aco", seeds=range(2), ants=1, iterations=1)
heavy = {"hydra", "omegaconf", "mlflow", "matplotlib", "pandas", "sqlalchemy", "rich"}
print(*sorted(heavy & sys.modules.keys()))
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == ""


def test_everything_public_is_documented() -> None:
    for name in acoexp.__all__:
        thing = getattr(acoexp, name)
        assert inspect.getdoc(thing), name
        for member, value in vars(thing).items() if inspect.isclass(thing) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{member}"


def test_every_parameter_of_solve_is_explained() -> None:
    for function in (solve, solve_many):
        text = inspect.getdoc(function) or ""
        assert all(f"{name}:" in text for name in inspect.signature(function).parameters)
