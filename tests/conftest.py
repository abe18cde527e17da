"""Which tests run when nothing is said: all but those of whole commands, servers and the pages of the docs."""

from __future__ import annotations

from pathlib import Path

import pytest

LONG = "end_to_end"


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave ``tests/end_to_end`` to whoever names it: ``pytest tests/end_to_end``."""
    named = any(LONG in argument for argument in config.args)
    return True if collection_path.name == LONG and not named else None
