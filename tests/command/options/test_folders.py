"""The folders of runs and sweeps: own ones are told from those that a person names."""

from __future__ import annotations

from acoexp.command.options.folders import is_named, own_folders


def test_a_run_and_a_sweep_get_a_folder_unless_one_is_named() -> None:
    run, sweep = own_folders(["seed=1"])
    assert run.startswith("hydra.run.dir=outputs/runs/")
    assert sweep.startswith("hydra.sweep.dir=outputs/sweeps/")
    assert own_folders(["hydra.run.dir=here", "+hydra.sweep.dir=there"]) == []
    assert own_folders(["seed=1"]) != [run, sweep]


def test_a_runs_own_folder_is_told_from_one_that_a_person_names() -> None:
    own = own_folders([])[0].partition("=")[2]
    assert not is_named(own)
    assert all(is_named(folder) for folder in ("here", "outputs/runs", "outputs/runs/mine", f"{own}/x"))
