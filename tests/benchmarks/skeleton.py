"""The least that one tracked trial costs: the same imports, one MLflow run, the same two pictures, no colony."""

from __future__ import annotations

import time
from pathlib import Path

import hydra
import numba  # noqa: F401
import numpy as np
import scipy.sparse.csgraph  # noqa: F401
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from mlflow import MlflowClient
from mlflow.entities import Metric, Param
from omegaconf import DictConfig


@hydra.main(version_base="1.3", config_path=None)
def main(config: DictConfig) -> None:
    Path("outputs").mkdir(exist_ok=True)
    client = MlflowClient("sqlite:///outputs/mlflow.db")
    experiment = client.get_experiment_by_name("skeleton")
    identity = experiment.experiment_id if experiment else client.create_experiment("skeleton")
    run = client.create_run(identity)
    now = int(time.time() * 1000)
    metrics = [Metric("best_length", 30.0, now, cycle) for cycle in range(200)]
    client.log_batch(run.info.run_id, metrics, [Param(f"p{i}", "1") for i in range(25)])
    client.set_terminated(run.info.run_id)

    figure = Figure(figsize=(6, 6.6), layout="constrained")
    axes = figure.subplots()
    axes.imshow(np.zeros((20, 20)), cmap="Greys")
    axes.set_xticks(np.arange(21) - 0.5, minor=True)
    axes.set_yticks(np.arange(21) - 0.5, minor=True)
    axes.grid(which="minor")
    axes.plot(range(20), label="path")
    axes.plot(range(20), label="as walked")
    figure.legend(loc="outside lower center", ncols=4)
    axes.set(title="title", xlabel="column", ylabel="row")
    FigureCanvasAgg(figure)
    figure.savefig("path.png")
    figure = Figure(figsize=(7, 4), layout="constrained")
    axes = figure.subplots()
    axes.axhline(30.0, label="optimum")
    axes.plot(np.ones(200), label="best in the cycle")
    axes.set(title="title", xlabel="cycle", ylabel="path length (cells)")
    axes.legend()
    FigureCanvasAgg(figure)
    figure.savefig("convergence.png")


if __name__ == "__main__":
    main()
