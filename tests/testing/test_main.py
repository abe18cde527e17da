"""``python -m acoexp.testing``: the digest of a part that is named by module and class."""

from __future__ import annotations

import pytest

from acoexp.strategies.diffusion.gaussian import Gaussian
from acoexp.testing.__main__ import main
from acoexp.testing.checks import digest


def test_it_prints_the_digest_of_the_part_with_these_parameters_and_settings(
    capsys: pytest.CaptureFixture[str],
) -> None:
    main("acoexp.strategies.diffusion.gaussian:Gaussian", '{"gamma": 0.2}', '"pd"', '{"ants": 3}')
    assert capsys.readouterr().out.strip() == digest(Gaussian(gamma=0.2), "pd", {"ants": 3})
