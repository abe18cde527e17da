"""``acoexp.record``: what a person gets in Python."""

from __future__ import annotations

from html import unescape
from pathlib import Path

import numpy as np
import pytest
from samples import everything

from acoexp import Recording, SettingsError, StrategyError, record, solve
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

pytestmark = pytest.mark.slow_without_jit


def test_its_result_is_what_solve_returns(recording: Recording) -> None:
    assert everything(recording.result) == everything(solve("env2", "pdg", seed=3, iterations=12))
    assert repr(recording) == f"<recording of 12 cycles of {recording.result!r}>"


def test_the_pheromone_on_all_edges_is_that_of_a_trial_of_so_many_cycles(recording: Recording) -> None:
    edges = recording.pheromone_on_edges(4)
    expected = Solver(load_map("env2"), resolve("pdg", {"iterations": 4})).pheromone(3)
    assert np.array_equal(edges, expected, equal_nan=True)
    assert np.float32(np.nanmax(edges)) == recording.pheromone[4].max()


def test_the_arguments_are_those_of_solve() -> None:
    with pytest.raises(SettingsError, match="seed"):
        record("env2", seed=-1, iterations=1)
    with pytest.raises(SettingsError, match="start, goal and moves"):
        record("env2", start=(0, 0))
    with pytest.raises((SettingsError, StrategyError), match="nowhere"):
        record("nowhere")


def test_too_large_a_recording_is_refused_before_it_takes_memory() -> None:
    with pytest.raises(SettingsError, match="iterations: expected at most"):
        record(np.zeros((1000, 1000)), "aco", iterations=1000)


def test_it_is_saved_whole_or_not_at_all(recording: Recording, tmp_path: Path) -> None:
    recording.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    with pytest.raises(OSError, match="nowhere"):
        recording.save(tmp_path / "nowhere" / "page.html")
    (tmp_path / "folder").mkdir()
    with pytest.raises(OSError, match="folder"):
        recording.save(tmp_path / "folder")
    assert {path.name for path in tmp_path.iterdir()} == {"page.html", "folder"}


def test_in_a_notebook_it_is_the_page_in_a_frame(recording: Recording, tmp_path: Path) -> None:
    recording.save(tmp_path / "page.html")
    shown = recording._repr_html_()
    assert shown.startswith("<iframe ")
    inner = unescape(shown.partition('srcdoc="')[2].partition('"')[0])
    assert inner == (tmp_path / "page.html").read_text(encoding="utf-8")
