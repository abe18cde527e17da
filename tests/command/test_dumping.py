"""Configurations as YAML: the text is OmegaConf's, whatever is in it."""

from __future__ import annotations

from typing import Any

from hypothesis import given
from hypothesis import strategies as st
from omegaconf import OmegaConf

from acoexp.command.dumping import yaml_of

SIGNS = st.sampled_from("ab \n\t'\"#:,-?{}[]&*!|>%@`~\\/=0.1é😀\x07\u2028")
TEXTS = st.text(st.characters(exclude_characters="$"), max_size=60) | st.text(SIGNS, max_size=200)
KEYS = TEXTS.filter(bool) | st.integers() | st.booleans()
LEAVES = st.none() | st.booleans() | st.integers() | st.floats() | TEXTS
TREES = st.recursive(
    LEAVES, lambda inner: st.lists(inner, max_size=4) | st.dictionaries(KEYS, inner, max_size=5), max_leaves=20
)


@given(st.dictionaries(KEYS, TREES, max_size=5))
def test_any_configuration_is_written_as_omegaconf_writes_it(values: dict[Any, Any]) -> None:
    config = OmegaConf.create(values)
    assert yaml_of(config) == OmegaConf.to_yaml(config)


@given(st.dictionaries(TEXTS.filter(bool), TREES, min_size=1, max_size=5))
def test_so_is_hydras_own_part(values: dict[Any, Any]) -> None:
    config = OmegaConf.create({"hydra": values})
    assert yaml_of(config) == OmegaConf.to_yaml(config)


def test_references_stay() -> None:
    assert yaml_of(OmegaConf.create({"a": "${b}", "b": 1})) == "a: ${b}\nb: 1\n"


def test_secrets_of_addresses_are_masked_wherever_they_stand() -> None:
    told = {"uri": "http://me:topsecret@host", "hydra": {"task": ["uri=http://me:topsecret@host", "x=topsecret"]}}
    for part in (told, {"hydra": told["hydra"]}):
        assert "topsecret" not in yaml_of(OmegaConf.create(part), "http://me:topsecret@host", "")
