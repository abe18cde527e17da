"""What a report consists of: all of it in every form, of few maps and of many."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from compared import LOST, sample

from acoexp.compare.configuration import parse_configurations
from acoexp.compare.contents import MANY_MAPS, Compared, write_report
from acoexp.compare.learning import learning_row
from acoexp.compare.maps import MapFacts

CONFIGURATIONS = parse_configurations(["aco", "pd", "_odd$x$: pdg"], {})
OVER_MAPS = {"values.csv", "ranks.csv", "effects.csv", "budgets.csv"}
PICTURES = {"curves", "effects", "profiles", "targets", "budgets", "ranks"}


def written(folder: Path, maps: int, worst: float = 3.0) -> Path:
    """Return a folder with a report on so many maps; the later a configuration stands, the better it is."""
    draw = np.random.default_rng(maps)
    samples = [
        [
            sample((10.0 + draw.random((4, 5)) + (worst - place)).tolist(), one.label, f"map-{number}")
            for place, one in enumerate(CONFIGURATIONS)
        ]
        for number in range(maps)
    ]
    facts = [MapFacts(f"map-{number}", f"digest-{number}", 10.0, 10, 90) for number in range(maps)]
    learning = [learning_row(of_map[-1], of_map[0]) for of_map in samples]
    write_report(folder, Compared(CONFIGURATIONS, facts, samples, 4, learning))
    return folder


@pytest.fixture(scope="module")
def few(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a report on a few maps, enough for a verdict."""
    return written(tmp_path_factory.mktemp("few"), 6)


@pytest.fixture(scope="module")
def many(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a report on more maps than a person reads about one by one."""
    return written(tmp_path_factory.mktemp("many"), MANY_MAPS + 1)


def rows(folder: Path, name: str) -> list[dict[str, str]]:
    """Return the rows of a CSV."""
    with (folder / name).open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def content(folder: Path) -> dict[str, Any]:
    """Return what the JSON says."""
    found: dict[str, Any] = json.loads((folder / "report.json").read_text("utf-8"))
    return found


def test_every_form_has_the_verdict(few: Path) -> None:
    said = content(few)["verdict"]
    assert said["text"].startswith("Over 6 maps the configurations differ (Friedman: ")
    assert said["friedman"]["f_p"] < 0.05
    assert said["critical_difference"] == pytest.approx(1.353, abs=1e-3)
    assert "Over 6 maps the configurations differ" in (few / "index.html").read_text("utf-8")
    assert "\n> Over 6 maps the configurations differ" in (few / "report.md").read_text("utf-8")
    assert (few / "tables.tex").read_text("utf-8").count("\\toprule") == 7
    assert [row["cell"] for row in rows(few, "ranks.csv")] == ["_odd$x$", "pd", "aco"]
    assert {row["verdict"] for row in rows(few, "verdicts.csv")} >= {"_odd$x$ better"}


def test_files_have_a_row_for_each_map_and_configuration(few: Path) -> None:
    assert len(rows(few, "values.csv")) == len(rows(few, "cells.csv")) == 6 * 3
    held = [(row["a"], row["b"]) for row in rows(few, "effects.csv")]
    assert held == [("pd", "aco")] * 6 + [("_odd$x$", "aco")] * 6
    assert {(row["cell"], row["unit"]) for row in rows(few, "budgets.csv")} == {
        (one.label, unit) for one in CONFIGURATIONS for unit in ("cycles", "ant steps")
    }
    assert {row["cell"] for row in rows(few, "learning.csv")} == {"_odd$x$"}
    assert "What the colony learns" in (few / "report.md").read_text("utf-8")
    counts = {name: len(content(few)[name]) for name in ("values", "effects", "pairs")}
    assert counts == {"values": 18, "effects": 12, "pairs": 54}


def test_it_says_what_maps_are_for(few: Path, tmp_path: Path) -> None:
    assert "its interval is a bootstrap over maps" in (few / "report.md").read_text("utf-8")
    page = (written(tmp_path, 4) / "index.html").read_text("utf-8")
    assert "4 maps allow no verdict over maps: it takes 5 or more." in page
    assert not (tmp_path / "verdicts.csv").exists()
    assert not (tmp_path / "ranks.svg").exists()


@pytest.mark.parametrize("report", ["few", "many"])
def test_every_picture_is_on_the_page_and_beside_it(report: str, request: pytest.FixtureRequest) -> None:
    folder: Path = request.getfixturevalue(report)
    expected = PICTURES - ({"curves"} if report == "many" else set())
    assert {path.stem for path in folder.glob("*.svg")} == {path.stem for path in folder.glob("*.png")} == expected
    assert (folder / "index.html").read_text("utf-8").count("<svg") == len(expected)
    assert {*re.findall(r"\((\w+)\.svg\)", (folder / "report.md").read_text("utf-8"))} == expected


def test_the_page_needs_no_other_file(many: Path) -> None:
    page = (many / "index.html").read_text("utf-8")
    assert not re.search(r"<(img|link|script|iframe)\b|@import|url\((?!#)", page)


def test_of_many_maps_tables_of_each_are_folded_and_named_by_their_files(many: Path) -> None:
    page, text = ((many / name).read_text("utf-8") for name in ("index.html", "report.md"))
    assert page.count("<details>") == 5
    assert "map-3" not in text
    assert "`pairs.csv` has its 117 rows." in text
    assert text.startswith("# Comparison of ant colonies\n\n3 configurations on 13 maps: ")
    assert (many / "tables.tex").read_text("utf-8").count("\\toprule") == 2


def test_on_one_map_it_says_that_there_is_no_verdict(tmp_path: Path) -> None:
    folder = written(tmp_path, 1)
    assert content(folder)["verdict"]["text"].startswith("One map allows no verdict over maps")
    assert {path.stem for path in folder.glob("*.svg")} == {"curves", "targets", "budgets"}


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("worst", [LOST, 0.0])
def test_where_all_is_lost_or_all_is_the_same_there_is_a_page_that_says_so(worst: float, tmp_path: Path) -> None:
    samples = [[sample([[10.0 + worst] * 3] * 4, one.label, name) for one in CONFIGURATIONS] for name in "abcde"]
    facts = [MapFacts(name, name, 10.0, 10, 90) for name in "abcde"]
    write_report(tmp_path, Compared(CONFIGURATIONS, facts, samples, 4, []))
    assert "No difference: on each of 5 maps" in (tmp_path / "index.html").read_text("utf-8")
    assert "NaN" not in (tmp_path / "report.json").read_text("utf-8")


def test_the_same_trials_give_the_same_bytes(few: Path, tmp_path: Path) -> None:
    again = written(tmp_path, 6)
    assert {path.name: path.read_bytes() for path in again.iterdir()} == {
        path.name: path.read_bytes() for path in few.iterdir()
    }
