"""Secrets: neither the store's password nor that of a study's database is written anywhere."""

from __future__ import annotations

from omegaconf import OmegaConf

from acoexp.command.sweep.secrets import without_secrets


def test_the_password_of_each_address_is_masked_also_where_it_stands_alone() -> None:
    addresses = {
        "tracking": {"uri": "postgresql://me:p@ss/word@server/runs"},
        "hydra": {"sweeper": {"storage": "postgresql://me:tr:oub/le@server/studies"}},
    }
    config = OmegaConf.create(addresses)
    text = without_secrets(f"{OmegaConf.to_yaml(config)}said: p@ss/word, tr:oub/le\n", config)
    assert text == (
        "tracking:\n  uri: postgresql://***@server/runs\n"
        "hydra:\n  sweeper:\n    storage: postgresql://***@server/studies\n"
        "said: ***, ***\n"
    )


def test_without_an_address_a_text_is_as_it_was() -> None:
    config = OmegaConf.create({"tracking": {"name": "none"}, "hydra": {"sweeper": {"storage": None}}})
    assert without_secrets("rho: 0.5 # None", config) == "rho: 0.5 # None"
