"""What diffusion does to lost ants, iterations and lengths (Figs 9, 10 and 11; the choice of axes is ours)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter, StrMethodFormatter

from acoexp.compare.statistics import Values
from acoexp_paper.figures.drawing import COLOURS, DASHES, HATCHES, WIDTH, new_figure
from acoexp_paper.published.tables import ALGOS, TITLES
from acoexp_paper.trials.samples import Samples

_COMMONEST = 7
_BAR = 0.27


def draw_lost(lost: Mapping[str, Values], ants: int) -> Figure:
    """Draw the mean number of ants lost in each cycle; by algorithm, float[iterations]."""
    figure, axes = _panel()
    for algo, means in lost.items():
        axes.plot(np.arange(1, means.size + 1), means, DASHES[algo], color=COLOURS[algo], label=TITLES[algo])
    axes.set(xscale="log", xlabel="cycle (log scale)", ylabel=f"lost ants per cycle, of {ants} (mean)")
    axes.set_ylim(bottom=0)
    return _finish(figure, axes)


def draw_iterations(samples: Samples) -> Figure:
    """Draw the share of trials that have found the optimum by each cycle."""
    figure, axes = _panel()
    for algo in ALGOS:
        sample = samples[algo]
        cycles = np.arange(1, sample.iterations + 1)
        times = np.sort(sample.hitting_time(sample.iterations + 1))
        share = np.searchsorted(times, cycles, side="right") / times.size
        axes.step(cycles, share, DASHES[algo], where="post", color=COLOURS[algo], label=TITLES[algo])
    axes.set(xscale="log", xlabel="cycle (log scale)", ylabel="trials that have found the optimum", ylim=(0, 1.02))
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    return _finish(figure, axes)


def draw_lengths(samples: Samples) -> Figure:
    """Draw the share of trials that converge to each of the commonest lengths, the others together."""
    counts = {algo: Counter(np.round(samples[algo].features["l2"], 4).tolist()) for algo in ALGOS}
    lengths = _commonest(counts, round(samples["aco"].optimum, 4))
    figure = new_figure(2.9)
    axes = figure.subplots()
    for place, algo in enumerate(ALGOS):
        share = [counts[algo][length] / samples[algo].found.size for length in lengths]
        share.append(1.0 - sum(share))
        axes.bar(
            np.arange(len(share)) + (place - 1) * _BAR, np.abs(np.round(share, 12)), _BAR, color=COLOURS[algo],
            hatch=HATCHES[algo], edgecolor="white", linewidth=0.5, label=TITLES[algo],
        )  # fmt: skip
    axes.set_xticks(
        np.arange(len(lengths) + 1), [*(f"{length:.4f}" for length in lengths), "others"], fontsize=7.5
    )
    axes.set(xlabel="length of convergence l2 (cells); the first is the optimum", ylabel="trials")
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    axes.legend(frameon=False, fontsize=8)
    return figure


def _commonest(counts: Mapping[str, Counter[float]], optimum: float) -> list[float]:
    """Return the lengths that most trials of all algorithms converge to, and the optimum, in their order."""
    total = sum(counts.values(), Counter[float]())
    commonest = sorted(total, key=lambda length: (-total[length], length))[:_COMMONEST]
    return sorted({optimum, *(length for length in commonest if not np.isnan(length))})


def _panel() -> tuple[Figure, Axes]:
    figure = new_figure(2.9, WIDTH * 0.75)
    return figure, figure.subplots()


def _finish(figure: Figure, axes: Axes) -> Figure:
    axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axes.margins(x=0)
    axes.legend(frameon=False, fontsize=8)
    return figure
