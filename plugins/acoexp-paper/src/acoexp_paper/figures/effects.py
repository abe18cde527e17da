"""What diffusion does to lost ants, iterations and lengths (Figs 9, 10 and 11; the choice of axes is ours).

The ten published trials stand beside ours where they are printed: of lost ants no number is.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Set
from itertools import chain

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter, StrMethodFormatter

from acoexp.compare.statistics import Flags, Values
from acoexp_paper.figures.drawing import COLOURS, DASHES, HATCHES, WIDTH, new_figure
from acoexp_paper.published.tables import ALGOS, TITLES, TRIALS, mended
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


def draw_iterations(samples: Samples, table: int) -> Figure:
    """Draw the share of trials that have found the optimum by each cycle, and that of a table's ten trials."""
    figure, axes = _panel()
    for algo in ALGOS:
        sample = samples[algo]
        cycles = np.arange(1, sample.iterations + 1)
        times = np.sort(sample.hitting_time(sample.iterations + 1))
        share = np.searchsorted(times, cycles, side="right") / times.size
        axes.step(cycles, share, DASHES[algo], where="post", color=COLOURS[algo], label=TITLES[algo])
        found = np.sort(mended(table, algo, "x1")[_finds_optimum(table, algo, sample.optimum)])
        axes.plot(
            found, np.arange(1, found.size + 1) / TRIALS, "o", color=COLOURS[algo], markersize=4,
            markeredgecolor="black", markeredgewidth=0.6, label=f"{TITLES[algo]}, published", clip_on=False,
        )  # fmt: skip
    axes.set(xscale="log", xlabel="cycle (log scale)", ylabel="trials that have found the optimum", ylim=(0, 1.02))
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    return _finish(figure, axes)


def _finds_optimum(table: int, algo: str, optimum: float) -> Flags:
    found: Flags = mended(table, algo, "l1") == round(optimum, 4)
    return found


def draw_lengths(samples: Samples, table: int) -> Figure:
    """Draw the share of trials that converge to each of the commonest lengths, the others together.

    Args:
        samples: Our trials.
        table: The table with the paper's; the lengths that they converge to are shown however rare with us.
    """
    counts = {algo: Counter(np.round(samples[algo].features["l2"], 4).tolist()) for algo in ALGOS}
    published = {algo: Counter(mended(table, algo, "l2").tolist()) for algo in ALGOS}
    lengths = _commonest(counts, {round(samples["aco"].optimum, 4), *chain.from_iterable(published.values())})
    figure = new_figure(2.9)
    axes = figure.subplots()
    for place, algo in enumerate(ALGOS):
        share = [counts[algo][length] / samples[algo].found.size for length in lengths]
        share.append(1.0 - sum(share))
        axes.bar(
            np.arange(len(share)) + (place - 1) * _BAR, np.abs(np.round(share, 12)), _BAR, color=COLOURS[algo],
            hatch=HATCHES[algo], edgecolor="white", linewidth=0.5, label=TITLES[algo],
        )  # fmt: skip
        axes.plot(
            np.arange(len(lengths)) + (place - 1) * _BAR,
            [published[algo][length] / TRIALS or np.nan for length in lengths],
            "D", color=COLOURS[algo], markersize=4.5, markeredgecolor="black", label=f"{TITLES[algo]}, published",
        )  # fmt: skip
    axes.set_xticks(
        np.arange(len(lengths) + 1), [*(f"{length:.4f}" for length in lengths), "others"], fontsize=7.5
    )
    axes.set(xlabel="length of convergence l2 (cells); the first is the optimum", ylabel="trials")
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    axes.legend(frameon=False, fontsize=8)
    return figure


def _commonest(counts: Mapping[str, Counter[float]], always: Set[float]) -> list[float]:
    """Return the lengths that most trials of all algorithms converge to, and some always, in their order."""
    total = sum(counts.values(), Counter[float]())
    commonest = sorted(total, key=lambda length: (-total[length], length))[:_COMMONEST]
    return sorted({*always, *(length for length in commonest if not np.isnan(length))})


def _panel() -> tuple[Figure, Axes]:
    figure = new_figure(2.9, WIDTH * 0.75)
    return figure, figure.subplots()


def _finish(figure: Figure, axes: Axes) -> Figure:
    axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axes.margins(x=0)
    axes.legend(frameon=False, fontsize=8)
    return figure
