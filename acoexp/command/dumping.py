"""Configurations as YAML: what OmegaConf writes, in a tenth of the time.

Where libyaml writes the same, it does; and what Hydra says of itself is the same for all jobs of a sweep, but for
a few lines: each part of it is written once.
"""

from __future__ import annotations

import pickle
from functools import lru_cache
from typing import Any

import yaml
from omegaconf import DictConfig, ListConfig, OmegaConf
from omegaconf._utils import OmegaConfDumper

from acoexp.tracking.mlflow.masking import masked

_Quick = getattr(yaml, "CDumper", yaml.Dumper)  # where PyYAML was built without libyaml, there is none


class _Dumper(_Quick):  # type: ignore[misc, valid-type]
    """libyaml's, with OmegaConf's rule for what is quoted."""


_Dumper.add_representer(str, OmegaConfDumper.str_representer)


def yaml_of(config: DictConfig | ListConfig | dict[str, Any], *addresses: str) -> str:
    """Return what ``OmegaConf.to_yaml`` does of a configuration, references unresolved, without passwords.

    Args:
        config: The configuration.
        addresses: Addresses in it whose secrets are masked wherever they stand.
    """
    plain: Any = config
    if isinstance(config, DictConfig | ListConfig):
        plain = OmegaConf.to_container(config, enum_to_str=True)
    if list(plain) != ["hydra"]:
        return _written(plain, addresses)
    parts = (pickle.dumps({"hydra": {key: value}}) for key, value in plain["hydra"].items())
    return "hydra:\n" + "".join(_below_its_heading(part, addresses) for part in parts)


@lru_cache(maxsize=64)
def _below_its_heading(part: bytes, addresses: tuple[str, ...]) -> str:
    return _written(pickle.loads(part), addresses).partition("\n")[2]


def _written(plain: Any, addresses: tuple[str, ...]) -> str:
    text = _quickly(plain) or OmegaConf.to_yaml(OmegaConf.create(plain))
    for address in {*addresses} - {""} or {""}:
        text = masked(text, address)
    return text


def _quickly(plain: Any) -> str | None:
    """Return what libyaml writes, or None where it would escape other signs than OmegaConf."""
    try:
        text: str = yaml.dump(plain, default_flow_style=False, allow_unicode=True, sort_keys=False, Dumper=_Dumper)
    except UnicodeEncodeError:  # bytes of a name that are no UTF-8
        return None
    return text if text.isascii() and "\\" not in text else None
