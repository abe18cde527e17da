"""A recording, and a browser to open its page in."""

from __future__ import annotations

import pytest
from pages import browser, show  # noqa: F401

from acoexp import Recording, record


@pytest.fixture(scope="session")
def recording() -> Recording:
    return record("env2", "pdg", seed=3, iterations=12)
