"""What a report is given: in what the command line differs from its preset, and a way to run trials."""

from __future__ import annotations

import os
from datetime import datetime
from pathlib import Path
from typing import Any

import pytest
from running import listing

from acoexp import Grid
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context
from acoexp.trial.seeds import parse_seeds

YARD = Grid([[0, 0], [0, 0]], name="yard")
SEEDS = parse_seeds("0-9")


def context(algo: str = "pdg", values: dict[str, Any] | None = None, **given: Any) -> Context:
    """Return the context of a command line that says these values."""
    return Context(
        algo=algo,
        preset=resolve(algo, {}),
        settings=resolve(algo, values or {}),
        grid=YARD,
        **{"folder": Path("report"), "trials_of": lambda settings, grid, seeds, show: None, **given},
    )


@pytest.mark.parametrize(
    ("values", "own"),
    [
        ({}, {}),
        ({"rho": 0.5, "ants": 10}, {}),
        ({"rho": 0.25, "ants": 3}, {"rho": 0.25, "ants": 3}),
        ({"field": {"reach": 4.0}}, {}),
        ({"field": {"reach": 3.0}, "q": 2.0}, {"q": 2.0, "field": {"reach": 3.0}}),
        ({"diffusion": {"gamma": 0.5}}, {}),
    ],
)
def test_own_settings_are_those_in_which_the_command_line_differs_from_its_preset(
    values: dict[str, Any], own: dict[str, Any]
) -> None:
    assert context(values=values).own_settings == own


def test_what_a_preset_sets_is_nobodys_own() -> None:
    assert context("mmas").own_settings == {}
    assert context("mmas", {"rho": resolve("aco", {}).scalars.rho}).own_settings == {"rho": 0.5}


@pytest.mark.parametrize(
    ("values", "own"),
    [
        ({}, []),
        ({"post": "geometric", "diffusion": {"gamma": 0.01}}, []),
        ({"diffusion": {"gamma": 0.5}}, ["diffusion"]),
        ({"post": "none", "heuristic": "potential_field"}, ["heuristic", "post"]),
    ],
)
def test_own_parts_are_the_groups_whose_part_or_parameter_differs(values: dict[str, Any], own: list[str]) -> None:
    assert context(values=values).own_parts == own


@pytest.mark.parametrize(("named", "shown_as"), [("aco on yard", "aco on yard"), ("", "aco")])
def test_trials_are_run_by_whoever_keeps_them_and_shown_by_name_while_they_run(named: str, shown_as: str) -> None:
    asked: list[Any] = []
    shown: list[tuple[str, int]] = []

    def trials_of(settings: Any, grid: Any, seeds: Any, show: Any) -> str:
        asked.append((settings, grid, seeds))
        show(7)
        return "the trials"

    settings = resolve("aco", {})
    made = context(trials_of=trials_of, show=lambda name, done: shown.append((name, done)))
    assert made.run(settings, YARD, SEEDS, named) == "the trials"
    assert asked == [(settings, YARD, SEEDS)]
    assert shown == [(shown_as, 7)]


def write(folder: Path, page: str, made_by: dict[str, Any] | None) -> None:
    """Write a report that is a page."""
    with context(folder=folder, made_by=made_by).draft() as draft:
        (draft / "page").write_text(page, encoding="utf-8")


def pages(folder: Path) -> dict[str, str]:
    """Return the page of each report in a folder, the first second of 2024 for its date."""
    return {path.parent.name: path.read_text("utf-8") for path in sorted(folder.glob("*/page"))}


def made_in_2024(report: Path) -> None:
    """Let a report be an old one."""
    date = datetime(2024, 5, 1, 12, 30, 15).timestamp()
    for path in (report / ".made-by.json", report):
        if path.exists():
            os.utime(path, (date, date))


def test_a_report_of_the_same_settings_is_replaced(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    for page in ("first", "second"):
        write(tmp_path / "mine", page, {"map": "yard", "settings": {"rho": 0.5}})
    assert pages(tmp_path) == {"mine": "second"}
    assert caplog.messages == []


@pytest.mark.parametrize("before", [{"map": "garden"}, None])
def test_a_report_of_other_settings_or_of_unknown_ones_is_kept_under_its_date(
    before: dict[str, Any] | None, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level("INFO")
    write(tmp_path / "mine", "old", before)
    made_in_2024(tmp_path / "mine")
    write(tmp_path / "mine", "new", {"map": "yard"})
    kept = "mine-2024-05-01-12-30-15"
    assert pages(tmp_path) == {"mine": "new", kept: "old"}
    said = (
        f"the report that was in {tmp_path / 'mine'} is of other settings, or was changed since, and is kept: "
        f"{tmp_path / kept}"
    )
    assert caplog.messages == [said]


@pytest.mark.parametrize("change", ["added", "changed", "unmarked"])
def test_a_report_to_which_a_person_did_anything_is_kept_under_its_date(change: str, tmp_path: Path) -> None:
    write(tmp_path / "mine", "first", {"map": "yard"})
    name = {"added": "notes.txt", "changed": "page", "unmarked": ".made-by.json"}[change]
    (tmp_path / "mine" / name).write_text("mine", encoding="utf-8")
    made_in_2024(tmp_path / "mine")
    write(tmp_path / "mine", "second", {"map": "yard"})
    assert (tmp_path / "mine-2024-05-01-12-30-15" / name).read_text("utf-8") == "mine"
    assert pages(tmp_path)["mine"] == "second"


def test_of_a_report_a_person_may_have_deleted_files(tmp_path: Path) -> None:
    write(tmp_path / "mine", "first", {"map": "yard"})
    (tmp_path / "mine" / "page").unlink()
    write(tmp_path / "mine", "second", {"map": "yard"})
    assert pages(tmp_path) == {"mine": "second"}


def test_of_many_reports_of_one_second_all_are_kept(tmp_path: Path) -> None:
    for rho in range(4):
        write(tmp_path / "mine", str(rho), {"rho": rho})
        made_in_2024(tmp_path / "mine")
    kept = "mine-2024-05-01-12-30-15"
    assert pages(tmp_path) == {"mine": "3", kept: "0", f"{kept}-2": "1", f"{kept}-3": "2"}


def test_a_report_that_fails_moves_nothing(tmp_path: Path) -> None:
    write(tmp_path / "mine", "old", {"map": "garden"})
    with pytest.raises(OSError, match="disk full"), context(folder=tmp_path / "mine", made_by={}).draft():
        raise OSError("disk full")
    assert pages(tmp_path) == {"mine": "old"}


def test_where_nobody_asks_by_what_a_report_was_made_it_is_replaced(tmp_path: Path) -> None:
    for page in ("first", "second"):
        write(tmp_path / "mine", page, None)
    assert listing(tmp_path) == {"mine", "mine/page"}


def test_an_empty_folder_is_taken(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level("INFO")
    (tmp_path / "mine").mkdir()
    write(tmp_path / "mine", "first", {"map": "yard"})
    assert pages(tmp_path) == {"mine": "first"}
    assert caplog.messages == []


@pytest.mark.parametrize("kind", ["file", "link"])
def test_what_is_no_folder_is_kept_like_a_report(kind: str, tmp_path: Path) -> None:
    mine = tmp_path / "mine"
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere" / "notes").touch()
    mine.touch() if kind == "file" else mine.symlink_to("elsewhere")
    write(mine, "new", {"map": "yard"})
    assert (mine / "page").read_text("utf-8") == "new"
    (kept,) = tmp_path.glob("mine-*")
    assert kept.is_symlink() == (kind == "link")
    assert listing(tmp_path / "elsewhere") == {"notes"}


# --- a report that writes straight to its folder


def write_straight(folder: Path, page: str, made_by: dict[str, Any] | None) -> None:
    """Write a report without a draft, as one may that knows nothing of them."""
    made = context(folder=folder, made_by=made_by)
    with made.place():
        made.folder.mkdir(parents=True, exist_ok=True)
        (made.folder / "page").write_text(page, encoding="utf-8")


def test_a_report_that_is_written_straight_replaces_its_like_and_keeps_others(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level("INFO")
    for page in ("first", "second"):
        write_straight(tmp_path / "mine", page, {"map": "yard"})
    assert (pages(tmp_path), caplog.messages) == ({"mine": "second"}, [])
    made_in_2024(tmp_path / "mine")
    write_straight(tmp_path / "mine", "third", {"map": "garden"})
    assert pages(tmp_path) == {"mine": "third", "mine-2024-05-01-12-30-15": "second"}
    assert len(caplog.messages) == 1
    write(tmp_path / "mine", "fourth", {"map": "garden"})
    assert pages(tmp_path)["mine"] == "fourth"


def test_if_it_fails_before_it_writes_nothing_has_moved(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level("INFO")
    write_straight(tmp_path / "mine", "old", {"map": "yard"})
    with pytest.raises(KeyboardInterrupt), context(folder=tmp_path / "mine", made_by={}).place():
        raise KeyboardInterrupt
    assert (pages(tmp_path), caplog.messages) == ({"mine": "old"}, [])


def test_if_it_fails_halfway_the_old_one_is_kept(tmp_path: Path) -> None:
    write_straight(tmp_path / "mine", "old", {"map": "yard"})
    made_in_2024(tmp_path / "mine")
    with pytest.raises(KeyboardInterrupt), context(folder=tmp_path / "mine", made_by={}).place():  # noqa: PT012
        (tmp_path / "mine").mkdir()
        raise KeyboardInterrupt
    assert pages(tmp_path) == {"mine-2024-05-01-12-30-15": "old"}
