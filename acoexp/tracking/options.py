"""The options of ``tracking``, declared as all parameters are."""

from __future__ import annotations

from dataclasses import dataclass

from acoexp.parameters import parameter

EXPERIMENT_VARIABLE = "MLFLOW_EXPERIMENT_NAME"
"""MLflow's own variable, which names the experiment where no key does."""


@dataclass(frozen=True, kw_only=True)
class Mlflow:
    """One MLflow run for each trial, or for each batch."""

    uri: str = parameter(
        "sqlite:///outputs/mlflow.db", "any store or server: http://..., postgresql://..., sqlite:///..."
    )
    experiment: str | None = parameter(
        None, "experiment that runs are in, and looked for; by default MLFLOW_EXPERIMENT_NAME, or else acoexp"
    )


@dataclass(frozen=True, kw_only=True)
class NoTracking:
    """Results are kept in the job's folder alone."""


TRACKING: dict[str, type] = {"mlflow": Mlflow, "none": NoTracking}
"""The options of ``tracking``, each with its parameters."""
