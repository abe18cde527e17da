"""What a strategy is: five kinds of parts that together make a colony.

A part is a frozen dataclass whose fields are its parameters. It may prepare state of its own, once, before
any ant walks, and names the kernel that acts during a trial. Kernels are compiled by
:func:`acoexp.colony.compiled.compiled`; they get the colony first and the part's own state second, and

* may read anything of :class:`acoexp.colony.state.Colony`,
* may change pheromone through :mod:`acoexp.colony.pheromone`, draw random numbers by
  :func:`acoexp.colony.random.uniform`, and write to the arrays of their own state,
* must do nothing else: no global state, no other array written, no exception raised.
"""

from __future__ import annotations

import inspect
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import is_compiled
from acoexp.colony.problem import Problem
from acoexp.errors import StrategyError
from acoexp.strategies.groups import STRATEGY_GROUPS

CONTRACT = 2
"""Version of this contract. It grows when a part could rely on something that was not there before; a part
that does says so by ``contract: ClassVar[int] = n``, and an older acoexp refuses it."""


class Part:
    """A part of a colony."""

    contract: ClassVar[int] = 1

    @property
    def kernel(self) -> Callable[..., Any] | None:
        """What acts: ``kernel = staticmethod(...)``, or a property where it depends on the parameters."""
        raise AttributeError(f"{type(self).__name__}.kernel")

    def prepare(self, problem: Problem) -> tuple[Any, ...]:
        """Return the part's own state: a tuple or NamedTuple of numbers and arrays.

        Called once for all trials on a problem. Arrays that are read-only are shared between threads; of the
        others each thread gets its own copies, brought back to these values before every trial.
        """
        return ()


class Heuristic(Part, ABC):
    """How desirable each move is, before the first cycle; it has no kernel, since nothing acts later."""

    @abstractmethod
    def eta(self, problem: Problem) -> NDArray[np.float64]:
        """Return eta, float64[rows, cols, 8] or anything that broadcasts to it: at least 0, finite.

        Values at moves that are not allowed do not matter.
        """


class Choice(Part):
    """Which move an ant makes.

    Its kernel is ``choose(colony, own, ant, cell, came) -> direction``: from ``cell``, where the ant (its row
    in the cycle) arrived in direction ``came`` (``NO_WAY_HERE`` on the start). It returns the direction of an
    allowed move to a cell that the ant has not visited, or ``LOST`` if there is none, or ``BACK`` (contract 2)
    to give the ant's last move back: the cell that it leaves stays tabu for it. It may change the pheromone of
    the edge it returns.
    """


class Diffusion(Part):
    """What pheromone does while an ant stands on a cell, before it chooses.

    Its kernel is ``diffuse(colony, own, ant, cell, came) -> None``, called at every step of every ant.
    """


class Post(Part):
    """How an ant's path is made better once it has arrived.

    Its kernel is ``optimise(colony, own, cells, count) -> count``: it changes the path in place, the first
    ``count`` entries of ``cells`` (int32), and returns how many cells are left. The result must be a path of
    allowed moves from start to goal. ``kernel = None`` leaves paths as they were walked.
    """


class Update(Part):
    """What happens to the pheromone at the end of a cycle.

    Its kernel is ``update(colony, own, raw, final, best) -> None``: ``raw`` and ``final`` are the trails of
    the cycle's ants as walked and as optimised (the same without a post-optimiser), ``best`` has the run's
    best path so far in row 0 and that path as it was walked in row 1. Lost ants have length inf.
    """

    def initial(self, problem: Problem) -> float | NDArray[np.float64]:
        """Return the initial pheromone: one level, or float64[rows, cols, 8]. By default tau0."""
        return problem.settings.tau0


STRATEGIES: dict[str, type[Part]] = dict(
    zip(STRATEGY_GROUPS, (Heuristic, Choice, Diffusion, Post, Update), strict=True)
)
"""What the part of each group has to be."""

CALLS = {
    Choice: "colony, own, ant, cell, came",
    Diffusion: "colony, own, ant, cell, came",
    Post: "colony, own, cells, count",
    Update: "colony, own, raw, final, best",
}
"""What the kernel of each kind of part is called with."""


def check_part(owner: type) -> None:
    """Refuse a class that leaves out what its kind has to have, or whose kernel the loop could not call.

    Raises:
        StrategyError: if so.
    """
    missing = sorted(getattr(owner, "__abstractmethods__", ()))
    if missing:
        raise StrategyError(f"expected {owner.__name__} to define {' and '.join(missing)}")
    call = next((call for kind, call in CALLS.items() if issubclass(owner, kind)), None)
    kernel = inspect.getattr_static(owner, "kernel", None)
    inherited = kernel is inspect.getattr_static(Part, "kernel")
    if (
        call is None
        or (kernel is None and issubclass(owner, Post))
        or (isinstance(kernel, property) and not inherited)
    ):
        return
    if kernel is None or inherited:
        raise StrategyError(f"expected {owner.__name__} to name its kernel: kernel = staticmethod(...)")
    bare = getattr(kernel, "__func__", kernel)
    name = getattr(bare, "__name__", repr(bare))
    if not is_compiled(bare):
        raise StrategyError(f"kernel {name} is not @compiled")
    if not isinstance(kernel, staticmethod):
        raise StrategyError(f"expected kernel = staticmethod({name})")
    takes = inspect.signature(getattr(bare, "py_func", bare)).parameters
    if len(takes) != len(call.split(", ")):
        raise StrategyError(f"kernel {name} takes ({', '.join(takes)}); it is called with ({call})")
