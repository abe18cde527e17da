"""The page in a browser: it plays what was recorded, for eyes, keys and other programs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from acoexp import Recording, SettingsError, record
from acoexp.watch import page as page_module
from acoexp.watch.packing import NARROWEST, WIDEST, Scale, packed
from acoexp.watch.page import data_of, framed, page_of

pytestmark = pytest.mark.slow_without_jit

HOSTILE = "</script><img src=x onerror=alert(1)>{{data}} & \"a'\u2028"


@pytest.fixture
def file(recording: Recording, tmp_path: Path) -> Path:
    recording.save(tmp_path / "page.html")
    return tmp_path / "page.html"


@pytest.fixture
def page(file: Path, show: Callable[..., Any]) -> Any:
    return show(file)


def state(page: Any, what: str) -> Any:
    return page.evaluate(f"acoexp.{what}")


def colony(page: Any, what: str, place: int = 0) -> Any:
    return page.evaluate(f"acoexp.colonies[{place}].{what}")


def test_it_opens_on_the_last_cycle_with_the_path_that_solve_finds(page: Any, recording: Recording) -> None:
    assert (state(page, "time"), state(page, "playing"), colony(page, "shownCycle()")) == (12, False, 12)
    assert colony(page, "path()") == recording.result.path.tolist()  # type: ignore[union-attr]
    assert "35.0711 (optimum)" in page.text_content(".facts")
    assert page.title() == "pdg on env2"


def test_each_cycle_shows_its_ants_its_pheromone_and_the_best_path_so_far(page: Any, recording: Recording) -> None:
    for cycle in (1, 2, 7, 12):
        page.evaluate(f"acoexp.seek({cycle})")
        shown, ways = colony(page, "ways()"), recording.ways(cycle)
        assert [len(way["cells"]) - 1 for way in shown] == [way.moves.size for way in ways]
        assert [way["lost"] for way in shown] == [way.lost for way in ways]
        assert [way["cells"][-1] == list(recording.grid.goal) for way in shown] == [not way.lost for way in ways]
        assert f"{recording.result.lost_ants[cycle - 1]} of 10" in page.text_content(".facts")
        best = next(best for best in reversed(recording.bests) if best.cycle <= cycle)
        assert len(colony(page, "path()")) == best.moves.size + 1
        levels = recording.pheromone[cycle]
        expected = Scale.of(levels, WIDEST, NARROWEST).bytes_of(levels)
        for row, col in [divmod(int(levels.argmax()), 20), (19, 0), (13, 12)]:
            assert colony(page, f"pheromone({row}, {col})") == expected[row, col]


def test_before_the_first_cycle_there_is_no_path(page: Any) -> None:
    page.evaluate("acoexp.seek(0)")
    assert colony(page, "path()") is None
    assert page.text_content("#cycle") == "cycle 0 of 12"


def test_it_plays_to_the_end_and_stops_there(page: Any, recording: Recording) -> None:
    for _ in range(5):
        page.click("#faster")
    page.click("#play")
    assert page.get_attribute("#play", "aria-label") == "Pause"
    page.wait_for_selector("#play[aria-label=Play]")
    assert (state(page, "time"), state(page, "playing")) == (12, False)
    assert colony(page, "path()") == recording.result.path.tolist()  # type: ignore[union-attr]


def test_ants_move_while_it_plays(page: Any) -> None:
    page.evaluate("acoexp.seek(0)")
    page.press("body", "Space")
    assert state(page, "playing")
    page.wait_for_timeout(150)
    moving = page.locator("canvas").first.screenshot()
    page.wait_for_timeout(150)
    assert page.locator("canvas").first.screenshot() != moving
    page.press("body", "Space")
    paused = state(page, "time")
    assert 0 < paused < 12
    page.wait_for_timeout(100)
    assert state(page, "time") == paused


def test_keys(page: Any) -> None:
    for key, time in [
        ("Home", 0), ("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1), ("End", 12), ("ArrowRight", 12),
    ]:  # fmt: skip
        page.press("body", key)
        assert state(page, "time") == time
    for key, speed in [("+", 4), ("-", 2), ("-", 1)]:
        page.press("body", key)
        assert state(page, "speed") == speed
    page.press("body", "?")
    assert page.is_visible("#help")
    page.press("body", "ArrowLeft")
    assert state(page, "time") == 12  # the help has the keys
    page.press("body", "Escape")
    assert not page.is_visible("#help")


def test_a_key_on_a_button_acts_once(page: Any) -> None:
    page.focus("#play")
    page.press("#play", "Space")
    assert state(page, "playing")
    page.press("#play", "Space")
    assert not state(page, "playing")


def test_the_slider_and_the_curves_lead_to_a_cycle(page: Any) -> None:
    page.fill("#slider", "5")
    assert state(page, "time") == 5
    assert page.get_attribute("#slider", "aria-valuetext") == "cycle 5 of 12"
    box = page.locator("#chart svg").bounding_box()
    page.mouse.click(box["x"] + box["width"] - 16, box["y"] + box["height"] / 2)
    assert state(page, "time") == 12
    page.mouse.click(box["x"] + 48, box["y"] + box["height"] / 2)
    assert state(page, "time") == 1


def test_a_cell_tells_its_pheromone_force_and_heuristic(page: Any, recording: Recording) -> None:
    box = page.locator("canvas[aria-label]").bounding_box()
    page.mouse.move(box["x"] + 0.5 * box["width"] / 20, box["y"] + 2.5 * box["height"] / 20)
    told = page.text_content(".cell")
    assert told.startswith("row 2, column 0: pheromone ")
    level = float(told.split("pheromone ")[1].split(" ")[0])
    assert level == pytest.approx(float(recording.pheromone[12, 2, 0]), rel=0.06)
    assert "force" in told
    assert "heuristic ↓" in told
    page.mouse.move(box["x"] + 3.5 * box["width"] / 20, box["y"] + 2.5 * box["height"] / 20)
    assert page.text_content(".cell") == "row 2, column 3: obstacle"
    page.mouse.move(1, 1)
    assert page.text_content(".cell") == ""


def test_those_who_do_not_see_it_hear_where_it_is(page: Any) -> None:
    page.press("body", "Home")
    page.press("body", "ArrowRight")
    assert page.text_content("[role=status]").startswith("Cycle 1. pdg: best so far ")
    assert page.get_attribute(".board canvas", "aria-label").startswith("Map of cycle 1. ")
    unnamed = (
        "[...document.querySelectorAll('button')].filter((b) => !(b.ariaLabel || b.textContent.trim())).length"
    )
    assert page.evaluate(unnamed) == 0


@pytest.mark.parametrize(("scheme", "background"), [("dark", "rgb(14, 17, 19)"), ("light", "rgb(244, 245, 242)")])
def test_it_is_dark_or_light_as_the_system_is_until_one_says_otherwise(
    file: Path, show: Callable[..., Any], scheme: str, background: str
) -> None:
    page = show(file, color_scheme=scheme)
    colour = "getComputedStyle(document.body).backgroundColor"
    assert page.evaluate(colour) == background
    page.press("body", "t")
    assert page.evaluate(colour) != background
    page.click("#theme")
    assert page.evaluate(colour) == background


def test_where_motion_is_not_wanted_it_goes_from_cycle_to_cycle(file: Path, show: Callable[..., Any]) -> None:
    page = show(file, reduced_motion="reduce")
    seen = page.evaluate(
        """async () => {
          const times = new Set();
          acoexp.play();
          while (times.size < 3) { times.add(acoexp.time); await new Promise(requestAnimationFrame); }
          acoexp.pause();
          return [...times];
        }"""
    )
    assert seen == [0, 1, 2]


@pytest.mark.parametrize("width", [360, 700, 1900])
def test_nothing_is_wider_than_the_window(
    recording: Recording, show: Callable[..., Any], tmp_path: Path, width: int
) -> None:
    (tmp_path / "page.html").write_text(page_of([packed(name, recording) for name in "abcd"]), encoding="utf-8")
    page = show(tmp_path / "page.html")
    page.set_viewport_size({"width": width, "height": 700})
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    boxes = [canvas.bounding_box() for canvas in page.locator(".board canvas").all()]
    assert len(boxes) == 4
    assert all(box["width"] > 150 and box["width"] == pytest.approx(box["height"], abs=1) for box in boxes)


def test_names_are_nothing_but_names(recording: Recording, show: Callable[..., Any], tmp_path: Path) -> None:
    text = page_of([packed(HOSTILE, recording)])
    (tmp_path / "page.html").write_text(text, encoding="utf-8")
    page = show(tmp_path / "page.html")
    assert page.text_content("#title") == f"{HOSTILE} on env2"
    assert data_of(text)["colonies"][0]["name"] == HOSTILE


def test_the_frame_of_a_notebook_plays_it(recording: Recording, browser: Any, tmp_path: Path) -> None:
    (tmp_path / "notebook.html").write_text(
        f"<body>{framed(page_of([packed('pdg', recording)]))}", encoding="utf-8"
    )
    page = browser.new_page()
    page.goto((tmp_path / "notebook.html").as_uri())
    frame = page.frame_locator("iframe")
    frame.locator("canvas[aria-label]").wait_for()
    frame.locator("#back").click()
    assert frame.locator("#cycle").text_content() == "cycle 11 of 12"
    page.close()


def test_trials_in_which_no_ant_arrives_are_shown_too(show: Callable[..., Any], tmp_path: Path) -> None:
    record("env2", "aco", iterations=3, max_steps=5).save(tmp_path / "lost.html")
    page = show(tmp_path / "lost.html")
    assert colony(page, "path()") is None
    assert "10 of 10" in page.text_content(".facts")
    record("env2", "aco", iterations=1).save(tmp_path / "one.html")
    assert state(show(tmp_path / "one.html"), "cycles") == 1


def test_large_maps_are_drawn_cell_by_cell(show: Callable[..., Any], tmp_path: Path) -> None:
    record("env2", "aco", iterations=2).save(tmp_path / "small.html")
    large = record([[0] * 400] * 300, "nav", iterations=2, start=(150, 20), goal=(150, 380))
    large.save(tmp_path / "large.html")
    page = show(tmp_path / "large.html")
    assert colony(page, "path()") == large.result.path.tolist()  # type: ignore[union-attr]
    page.evaluate("acoexp.seek(1.5)")


def test_a_page_too_large_to_be_opened_is_refused(recording: Recording, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_module, "LARGEST", 2**14)
    with pytest.raises(
        SettingsError, match=r"iterations: expected fewer, .* got 0\.\d MB for 12 cycles on a map of 400"
    ):
        page_of([packed("pdg", recording)])
