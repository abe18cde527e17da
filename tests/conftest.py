"""Which tests run if nothing is said, all but those of commands, servers and docs; and in which process."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

LONG = "end_to_end"
APART = ("test_docs.py", "test_page.py", "test_resume.py", "test_workers.py")
"""Files of long tests that share nothing: as a whole, each would keep one process busy to the end."""


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave ``tests/end_to_end`` to whoever names it: ``pytest tests/end_to_end``."""
    named = any(LONG in argument for argument in config.args)
    return True if collection_path.name == LONG and not named else None


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Hand out tests file by file, as ``--dist loadfile`` does, but those of long files one by one."""
    if config.getoption("dist") != "loadfile":
        return None
    from xdist.scheduler import LoadFileScheduling

    class ByFile(LoadFileScheduling):
        def _split_scope(self, nodeid: str) -> str:
            file = str(super()._split_scope(nodeid))
            return nodeid if f"/{LONG}/" in file and file.endswith(APART) else file

    return ByFile(config, log)
