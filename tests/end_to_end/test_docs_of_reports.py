"""Every command in the docs of reports runs as it stands there; test_docs.py has the other pages, beside it."""

from __future__ import annotations

from pathlib import Path

import pytest
from documented import REPORTS, run_blocks


@pytest.mark.slow_without_jit
@pytest.mark.parametrize("page", REPORTS, ids=lambda page: page.name)
def test_every_block_runs_and_the_pages_that_it_writes_open(
    page: Path,
    as_a_reader: Path,
    request: pytest.FixtureRequest,
) -> None:
    run_blocks(page, as_a_reader, request)
