"""Fixtures that open pages in a real browser."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")

_FLAGS = ("--no-sandbox", "--disable-background-networking", "--disable-component-update", "--disable-sync")


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    if CHROMIUM is None:
        pytest.skip("no chromium to open the page in")
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as driver:
        opened = driver.chromium.launch(executable_path=CHROMIUM, args=list(_FLAGS))
        yield opened
        opened.close()


@pytest.fixture
def show(browser: Any) -> Iterator[Callable[..., Any]]:
    """Open a page, wait for what ``awaits`` selects; what it complains of, or asks others for, fails the test."""
    complaints: list[str] = []
    contexts: list[Any] = []

    def opened(file: Path, awaits: str = "canvas[aria-label]", **options: Any) -> Any:
        contexts.append(browser.new_context(viewport={"width": 1300, "height": 850}, **options))
        page = contexts[-1].new_page()
        page.on("console", lambda said: complaints.append(f"{said.type}: {said.text}"))
        page.on("pageerror", lambda problem: complaints.append(str(problem)))
        page.on(
            "request",
            lambda asked: None if asked.url in (file.as_uri(), "data:,") else complaints.append(asked.url),
        )
        page.goto(file.as_uri())
        page.wait_for_selector(awaits)
        return page

    yield opened
    for context in contexts:
        context.close()
    assert complaints == []
