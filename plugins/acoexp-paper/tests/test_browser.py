"""The page in a real browser: every table and figure has its place on it, and none is wider than the page."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from html import unescape
from pathlib import Path

import pytest
from test_report import FIGURES, TABLES

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")

pytestmark = [
    pytest.mark.slow_without_jit,
    pytest.mark.skipif(CHROMIUM is None, reason="no chromium to open the page in"),
]

_FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
    "--disable-background-networking", "--disable-component-update", "--window-size=1100,900",
)  # fmt: skip
_MEASURE = """\
<pre id="measured"></pre><script>
const boxes = {};
for (const figure of document.querySelectorAll("figure")) {
  const box = figure.querySelector("svg, table").getBoundingClientRect();
  const within = figure.querySelector("svg, div").getBoundingClientRect();
  boxes[figure.id] = [box.width, box.height, within.right];
}
document.getElementById("measured").textContent = JSON.stringify([boxes, document.documentElement.scrollWidth]);
</script>
"""


def test_it_shows_every_table_and_figure(report: Path, tmp_path: Path) -> None:
    html = (report / "index.html").read_text(encoding="utf-8")
    page = tmp_path / "page.html"
    page.write_text(html.replace("</body>", f"{_MEASURE}</body>"), encoding="utf-8")
    command = [str(CHROMIUM), *_FLAGS, f"--user-data-dir={tmp_path / 'profile'}", "--dump-dom", page.as_uri()]
    shown = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout
    found = re.search(r'<pre id="measured">(.*?)</pre>', shown, re.DOTALL)
    assert found is not None
    boxes, width = json.loads(unescape(found[1]))
    assert set(boxes) == {*FIGURES, *TABLES}
    assert width <= 1100
    for name, (wide, high, right) in boxes.items():
        assert wide > 150, name
        assert high > 40, name
        assert right <= 1100, name


def test_it_needs_no_other_file(report: Path) -> None:
    html = (report / "index.html").read_text(encoding="utf-8")
    assert re.findall(r'(?:src|href)="(?!#|data:)([^"]*)"', html) == []
    assert not re.search(r"url\((?!#)", html)
