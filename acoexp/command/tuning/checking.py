"""What is checked of a study's jobs before it begins: the ends of what is chosen from, each in some job."""

from __future__ import annotations

from hydra.core.config_loader import ConfigLoader
from omegaconf import DictConfig

from acoexp.command.messages import needs_extra
from acoexp.command.sweep.plan import Plan
from acoexp.command.tuning.space import Space
from acoexp.errors import SettingsError
from acoexp.tracking.mlflow.store import Store


def check_installed() -> None:
    """Refuse to begin without Optuna.

    Raises:
        SettingsError: if it, or what one of its samplers needs, is not installed.
    """
    try:
        import cmaes  # noqa: F401
        import optuna  # noqa: F401
    except ImportError as problem:
        raise SettingsError(needs_extra("hydra/sweeper", "optuna")) from problem


def checked_plan(config: DictConfig, loader: ConfigLoader, space: Space, storage: str | None) -> Plan:
    """Return a plan of a few jobs that together have each choice and both ends of each interval.

    Raises:
        AcoexpError, HydraException: if one of them is wrong, or is one that a study can learn nothing from.
    """
    plan = Plan(config, loader, [], space.samples())
    if plan.has_reports:
        raise SettingsError("report: expected none with hydra/sweeper=optuna, which goes by the length of a path")
    if storage is not None and Store(storage).uri in {tracker.address for tracker in plan.trackers.values()}:
        raise SettingsError("hydra.sweeper.storage: expected a database of its own; got that of tracking.uri")
    return plan
