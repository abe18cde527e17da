"""``report.export=ioh``: trials in the data format of IOHprofiler, which IOHanalyzer and iohinspector read.

A folder for each configuration has a JSON for each map, a *function* there, and beside it the ``.dat`` that its
runs are in, one for each seed (Doerr et al. 2018; Wang et al. 2022; written as IOHexperimenter's logger
``Analyzer`` does).

An *evaluation* is an ant's walk. A cycle's ants walk before any of them counts, so its best path stands at the
last of their walks. ``raw_y`` is the gap to the map's exact optimum as a share of it, 0 the optimum; where there
is no path yet, it is that of a path over all free cells, which no path exceeds. ``ant_steps`` are the moves made
until then.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.compare.configuration import Configuration
from acoexp.compare.maps import MapFacts
from acoexp.compare.sample import Row, Sample

VERSION = "0.4.2"
"""Of IOHexperimenter, whose files these are like."""

_UNUSUAL = re.compile(r"[^A-Za-z0-9.-]+")


class Run(NamedTuple):
    """One trial as IOHprofiler sees it.

    Attributes:
        lines: float[n, 3]: evaluations, gap and ant steps, where the gap gets smaller, and at the end.
        evaluations: How many there were.
        best: The line that found the smallest gap.
    """

    lines: NDArray[np.float64]
    evaluations: int
    best: NDArray[np.float64]


def export_trials(
    folder: Path,
    compared: Sequence[Configuration],
    maps: Sequence[MapFacts],
    samples: Sequence[Sequence[Sample]],
) -> None:
    """Write trials.

    Args:
        folder: Where the configurations' folders are to be.
        compared: The configurations.
        maps: The maps.
        samples: The trials on each map, in the order of the configurations.
    """
    for number, (facts, of_map) in enumerate(zip(maps, samples, strict=True), 1):
        for place, (one, sample) in enumerate(zip(compared, of_map, strict=True), 1):
            _export(folder / f"{place}-{_plain(one.label)}", number, facts, one, sample)


def runs_of(sample: Sample, ants: int, worst: float) -> Iterator[Run]:
    """Yield the trials of a configuration, each with its lines; the first is always that of evaluation 1.

    Args:
        sample: The trials.
        ants: How many walk in a cycle.
        worst: The gap where there is no path yet.
    """
    gaps = np.where(np.isinf(sample.gaps), worst, sample.gaps)
    evaluations = ants * np.arange(1, sample.iterations + 1, dtype=np.float64)
    for curve, steps, cycles in zip(gaps, sample.steps, sample.features["cycles"].astype(int), strict=True):
        better = np.diff(curve[:cycles], prepend=worst) < 0.0
        better[-1] = True
        lines = np.column_stack([evaluations, curve, steps])[:cycles][better]
        if lines[0, 0] > 1.0:
            lines = np.vstack([[1.0, worst, 0.0], lines])
        yield Run(lines, int(evaluations[cycles - 1]), lines[lines[:, 1].argmin()])


def _export(folder: Path, number: int, facts: MapFacts, one: Configuration, sample: Sample) -> None:
    name = f"f{number}_{_plain(facts.name)}"
    data = Path(f"data_{name}", f"IOHprofiler_f{number}_DIM{facts.side}.dat")
    (folder / data).parent.mkdir(parents=True)
    worst = math.sqrt(2.0) * facts.free / facts.optimum - 1.0
    described: list[Row] = []
    with (folder / data).open("w", encoding="utf-8") as file:
        for seed, run in enumerate(runs_of(sample, one.settings.scalars.ants, worst)):
            file.write("evaluations raw_y ant_steps\n")
            file.writelines(f"{walks:.0f} {gap:.10f} {steps:.0f}\n" for walks, gap, steps in run.lines.tolist())
            walks, gap, _ = run.best.tolist()
            best = {"evals": int(walks), "y": gap, "x": []}
            described.append({"instance": 1, "evals": run.evaluations, "best": best, "seed": seed})
    about = {
        "version": VERSION,
        "suite": "acoexp",
        "function_id": number,
        "function_name": facts.name,
        "maximization": False,
        "algorithm": {"name": one.label, "info": one.text},
        "experiment_attributes": [{"map_digest": f"digest {facts.digest}"}],
        "run_attributes": ["seed"],
        "attributes": ["evaluations", "raw_y", "ant_steps"],
        "scenarios": [{"dimension": facts.side, "path": data.as_posix(), "runs": described}],
    }
    text = json.dumps(about, indent=1, allow_nan=False, ensure_ascii=False)
    (folder / f"IOHprofiler_{name}.json").write_text(f"{text}\n", encoding="utf-8")


def _plain(name: str) -> str:
    """Return a name of a file or folder; a number before it tells it from others."""
    return _UNUSUAL.sub("_", name)[:60].strip("_.") or "map"
