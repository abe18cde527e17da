"""Texts key=value; what is refused, tests of configurations and maps show."""

from __future__ import annotations

import pytest

from acoexp import SettingsError
from acoexp.compare.overrides import nested


def test_keys_are_nested_and_parts_named() -> None:
    assert nested(["rho=0.3", "diffusion=none", "diffusion.gamma=1e-3", "map.size=[4, 5]"]) == {
        "rho": 0.3, "diffusion": {"name": "none", "gamma": 0.001}, "map": {"size": [4, 5]},
    }  # fmt: skip


@pytest.mark.parametrize("text", ["", "a", "=1", "a.=1", "[a]=1"])
def test_what_is_no_key_with_a_value_is_refused(text: str) -> None:
    with pytest.raises(SettingsError, match="expected key=value; got "):
        nested([text])
