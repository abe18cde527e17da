"""Every format: its sample is a map, and whatever becomes of it is a map or refused; see ``tests/fuzz.py``."""

from __future__ import annotations

import random
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mutations import FORMATS, mutated

from acoexp import MapError

FUZZ = Path(__file__).parents[1] / "fuzz.py"


@pytest.mark.parametrize("name", FORMATS)
def test_the_sample_of_a_format_is_a_map(name: str, tmp_path: Path) -> None:
    FORMATS[name].load(tmp_path, FORMATS[name].files)


@settings(deadline=None)
@given(st.sampled_from(sorted(FORMATS)), st.integers(0, 2**32))
def test_what_becomes_of_it_is_a_map_or_refused_as_none(name: str, seed: int) -> None:
    with TemporaryDirectory() as folder, suppress(MapError):
        FORMATS[name].load(Path(folder), mutated(random.Random(seed), FORMATS[name].files))


@settings(deadline=None)
@given(st.sampled_from(sorted(FORMATS)), st.data())
def test_what_never_was_one_is_refused(name: str, data: st.DataObject) -> None:
    files = FORMATS[name].files
    one = data.draw(st.sampled_from(sorted(files)))
    with TemporaryDirectory() as folder, suppress(MapError):
        FORMATS[name].load(Path(folder), {**files, one: data.draw(st.binary(max_size=60))})


def test_the_command_tells_how_many_it_read() -> None:
    done = subprocess.run([sys.executable, FUZZ, "--inputs", "50"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "50 inputs, " in done.stdout
