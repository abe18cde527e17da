"""The scalars of a colony: the numbers that all of its parts share."""

from __future__ import annotations

from dataclasses import dataclass

from acoexp.parameters import parameter


@dataclass(frozen=True, kw_only=True)
class ColonySettings:
    """The scalars of a colony; the defaults are those of Liu et al. 2017, Sect. 5, where it gives them."""

    alpha: float = parameter(1.1, "weight of pheromone in the choice", minimum=0.0, maximum=100.0)
    beta: float = parameter(12.0, "weight of the heuristic in the choice", minimum=0.0, maximum=100.0)
    rho: float = parameter(0.5, "share of the pheromone that evaporates in a cycle", minimum=0.0, maximum=1.0)
    ants: int = parameter(10, "ants that walk in a cycle", minimum=1, maximum=100_000)
    iterations: int = parameter(200, "cycles in a trial", minimum=1, maximum=1_000_000)
    max_steps: int | None = parameter(
        None, "moves, those back too, after which an ant is lost; without it no number is too many", minimum=1
    )
    patience: int | None = parameter(
        None,
        "cycles in a row without a better path that end a trial; without it no number does",
        minimum=1,
    )
    q: float = parameter(
        1.0, "pheromone that an ant spreads over its path; not in the paper", minimum=1e-100, maximum=1e100
    )
    tau0: float = parameter(
        1.0, "pheromone everywhere at the start; not in the paper", minimum=1e-100, maximum=1e100
    )
    pheromone: str = parameter(
        "edges",
        "where pheromone lies (Eqs 18, 19 or Sect. 3.4, step 3); all edges into a cell share its level",
        choices=("edges", "cells"),
    )
    order: str = parameter(
        "in_turn",
        "how the ants of a cycle walk: one after another, one step each in turn, or in pairs from both ends",
        choices=("in_turn", "lock_step", "two_ended"),
    )
    dead_end: str = parameter(
        "lost",
        "what becomes of an ant with no cell left to go to: it is lost, or steps back and goes on from there",
        choices=("lost", "step_back"),
    )
