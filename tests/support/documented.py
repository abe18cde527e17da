"""What a reader of the README and the docs does: run every block as it stands there, and open what it writes."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from pages import CHROMIUM

ROOT = Path(__file__).parents[2]
BLOCK = re.compile(r"^```(bash|python)\n(.*?)^```$", re.M | re.S)

PAGES = [ROOT / "README.md", *sorted({*(ROOT / "docs").glob("*.md")} - {ROOT / "docs" / "engines.md"})]
"""Pages whose blocks run; docs/engines.md needs clusters and databases, and has a test of its own."""

# what needs a checkout, a server, or a whole test run has a test of its own
ELSEWHERE = ("pytest", "mlflow ui", "tests/benchmarks")


def commands(page: Path) -> list[tuple[str, str]]:
    """Return a page's runnable blocks as (language, text), without the steps that install the package."""
    blocks = [
        (language, re.sub(r"pip install .+? && ", "", text)) for language, text in BLOCK.findall(page.read_text())
    ]
    return [(language, text) for language, text in blocks if not any(word in text for word in ELSEWHERE)]


@pytest.fixture
def as_a_reader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a checkout's tests, and a shell in which ``python`` and ``acoexp`` are this environment's."""
    (tmp_path / "tests").symlink_to(ROOT / "tests")
    monkeypatch.setenv("PATH", f"{Path(sys.executable).parent}:/usr/bin:/bin")
    return tmp_path


def run_blocks(page: Path, folder: Path, request: pytest.FixtureRequest) -> None:
    """Run a page's blocks in a folder, and open the pages that they write, where there is a browser."""
    for language, text in commands(page):
        command = ["bash", "-euo", "pipefail", "-c", text] if language == "bash" else [sys.executable, "-c", text]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, f"{text}\n{done.stderr}"
    written = [*folder.glob("outputs/reports/*/index.html")]
    if written and CHROMIUM:
        show = request.getfixturevalue("show")
        for report in written:
            assert show(report, awaits="body").title()
