"""What is written of a configuration, without the passwords of the addresses in it."""

from __future__ import annotations

from omegaconf import DictConfig, OmegaConf

from acoexp.tracking.mlflow.masking import masked

_ADDRESSES = ("tracking.uri", "hydra.sweeper.storage")


def without_secrets(text: str, config: DictConfig) -> str:
    """Return a text that repeats a configuration, the secrets of its addresses masked wherever they stand."""
    for address in addresses_of(config):
        text = masked(text, address)
    return text


def addresses_of(config: DictConfig) -> list[str]:
    """Return the addresses in a configuration, which may have passwords in them."""
    return [str(OmegaConf.select(config, key, default=None) or "") for key in _ADDRESSES]
