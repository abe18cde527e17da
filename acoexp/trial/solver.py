"""The solver: one configuration on one map, made ready once, then run for any number of seeds and threads."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sized
from concurrent.futures import ThreadPoolExecutor, as_completed
from copy import copy
from functools import cache
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.loop import make_loop
from acoexp.colony.orders import ORDERS
from acoexp.colony.problem import Problem
from acoexp.colony.state import Kernel, Kernels, Record, Room, Trails
from acoexp.errors import AcoexpError, SettingsError, StrategyError, shown
from acoexp.grid.grid import Grid
from acoexp.kernels.cache import compile_once
from acoexp.kernels.digest import digest_of
from acoexp.trial import failures
from acoexp.trial.outcome import Failure
from acoexp.trial.preparation import prepare
from acoexp.trial.result import Result
from acoexp.trial.seeds import check_seed
from acoexp.trial.settings import Settings
from acoexp.trial.threads import check_threads
from acoexp.trial.workspace import End, Workspace, new_record, new_workspace


@cache
def loop_of(order: str, steps_back: bool, kernels: Kernels) -> Kernel:
    """Return the loop over some kernels, one object however many solvers run it."""
    return make_loop(ORDERS[order], steps_back, kernels)


class Solver:
    """Runs trials of one configuration on one map."""

    def __init__(self, grid: Grid, settings: Settings) -> None:
        self.settings = settings
        self._kernels = Kernels(**{group: settings.parts[group].kernel for group in Kernels._fields})
        self._walks = settings.scalars.order, settings.scalars.dead_end == "step_back"
        self._loop, self._made_of = self._make_loop()
        self._prepare(grid)
        self._compile()

    def on(self, grid: Grid) -> Solver:
        """Return a solver of the same settings on another map; it shares what is compiled, so it is soon made.

        Raises:
            StrategyError: if a part fails, or answers with what is not asked for.
        """
        other = copy(self)
        other._prepare(grid)
        return other

    def solve(self, seed: int) -> Result:
        """Run one trial.

        Raises:
            SettingsError: if the seed is not a whole number from 0 to 2^64 - 1.
            StrategyError: if a part broke its contract.
        """
        return self.solve_many([seed], threads=1)[0]

    def solve_many(self, seeds: Iterable[int], threads: int | None = None) -> list[Result]:
        """Run a trial for each seed on some threads; results stand in the order of the seeds.

        A trial's result depends on its seed alone, whatever the threads and the order.

        Args:
            seeds: The seeds.
            threads: How many threads; by default one for each processor this process may use.

        Raises:
            SettingsError: for a seed or a number of threads that is not one.
            StrategyError: if a part broke its contract.
        """
        try:
            given = iter(seeds)
        except TypeError:
            raise SettingsError(f"seeds: expected whole numbers, such as range(10); got {shown(seeds)}") from None
        checked = [check_seed(seed) for seed in given]
        results: dict[int, Result] = {}

        def receive(outcome: Result | Failure) -> None:
            if isinstance(outcome, Failure):
                raise outcome.reason
            results[outcome.seed] = outcome

        self.run(dict.fromkeys(checked), receive, threads)
        return [results[seed] for seed in checked]

    def run(
        self, seeds: Iterable[int], receive: Callable[[Result | Failure], None], threads: int | None = None
    ) -> None:
        """Run a trial for each seed and hand over each outcome as soon as it is there, in any order.

        Args:
            seeds: Whole numbers from 0 to 2^64 - 1; taken one by one, so they need no room.
            receive: Called by one thread at a time; what it raises ends the run.
            threads: How many threads; by default one for each processor this process may use.

        Raises:
            SettingsError: for a number of threads that is not one.
        """
        waiting, busy = iter(seeds), Lock()
        stop = np.zeros(1, dtype=np.uint8)

        def work() -> None:
            workspace = self._new_workspace(stop)
            while not stop[0]:
                with busy:
                    seed = next(waiting, None)
                if seed is None:
                    return
                outcome = self._outcome(workspace, seed)
                if isinstance(outcome, Failure):  # it may have ended anywhere
                    workspace = self._new_workspace(stop)
                with busy:
                    if not stop[0]:
                        receive(outcome)

        workers = check_threads(threads)
        if isinstance(seeds, Sized):
            workers = min(workers, max(1, len(seeds)))
        # a thread even for a single trial: the main one has to hear Ctrl-C while a kernel runs
        with ThreadPoolExecutor(workers) as pool:
            try:
                for done in as_completed([pool.submit(work) for _ in range(workers)]):
                    done.result()
            except BaseException:
                stop[0] = 1
                raise

    def trials(self, seeds: Iterable[int]) -> Iterator[Result]:
        """Run one trial after the other in this thread, for callers that have threads of their own.

        Raises:
            SettingsError: if a seed is not a whole number from 0 to 2^64 - 1.
            StrategyError: if a part broke its contract.
        """
        workspace = self._new_workspace()
        for seed in seeds:
            yield self._trial(workspace, check_seed(seed))

    def room_after(self, seed: int) -> Room:
        """Run one trial and return what it worked on, as it is after the last cycle.

        Raises:
            SettingsError: if the seed is not a whole number from 0 to 2^64 - 1.
            StrategyError: if a part broke its contract.
        """
        workspace = self._new_workspace()
        self._trial(workspace, check_seed(seed))
        return workspace.room

    def pheromone(self, seed: int) -> NDArray[np.float64]:
        """Run one trial and return the pheromone on each move from each cell after it, float64[rows, cols, 8].

        That is after the last cycle, so ``iterations`` says which. Only levels relative to each other count; nan
        where a move is not allowed.

        Raises:
            SettingsError, StrategyError: As :func:`room_after`.
        """
        colony = self.room_after(seed).colony
        problem = self._ends[0].problem
        bordered = (colony.stored * colony.scale[0]).reshape(-1, problem.width, 8)
        return np.where(problem.allowed_edges(), bordered[1:-1, 1:-1], np.nan)

    def _outcome(self, workspace: Workspace, seed: int) -> Result | Failure:
        try:
            return self._trial(workspace, seed)
        except StrategyError as problem:
            problem.__cause__ = None
            return Failure(seed, problem.with_traceback(None))  # its frames would keep the trial's memory

    def _trial(self, workspace: Workspace, seed: int) -> Result:
        record = new_record(self.settings.scalars.iterations)
        for array, pristine in workspace.to_restore:
            np.copyto(array, pristine)
        try:
            with np.errstate(over="ignore"):  # without the JIT; uint64 wraps around on purpose
                verdict = int(self._loop(workspace.room, record, np.uint64(seed)))
        except KeyboardInterrupt:
            raise
        except BaseException as problem:
            raise failures.raised(self.settings, seed, problem) from problem
        self._check(verdict, seed)
        return self._result(workspace.room, record, seed)

    def _result(self, room: Room, record: Record, seed: int) -> Result:
        best, cycles = room.best, int(room.colony.cycle[0])
        arrived = best.length[0] < np.inf
        return Result(
            algo=self.settings.label,
            seed=seed,
            grid=self.grid,
            moves=_moves(best, 0) if arrived else None,
            raw_moves=_moves(best, 1) if arrived and self._kernels.post is not None else None,
            curve_pairs=record.pairs[:cycles],
            lost_ants=record.lost[:cycles],
            cycle_steps=record.ant_steps[:cycles],
        )

    def _check(self, verdict: int, seed: int) -> None:
        """Blame the part that broke its contract, if one did."""
        failures.check(self.settings, self.grid.moves, seed, verdict)

    def _prepare(self, grid: Grid) -> None:
        self.grid = grid
        self._ends = [self._end(grid)]
        if self.settings.scalars.order == "two_ended":
            way_back = Grid(grid.obstacles, start=grid.goal, goal=grid.start, moves=grid.moves, name=grid.name)
            self._ends.append(self._end(way_back))

    def _end(self, grid: Grid) -> End:
        """Return what the parts prepare for a way from one end to the other."""
        problem = Problem(grid, self.settings.scalars, self.settings.field)
        prepared = prepare(problem, self.settings)
        for what in ("field", "distance"):  # 17 and 8 bytes per cell that nobody needs any more
            problem.__dict__.pop(what, None)
        return End(problem, prepared)

    def _make_loop(self) -> tuple[Kernel, tuple[object, ...]]:
        """Return the loop, and all that its machine code depends on."""
        return loop_of(*self._walks, self._kernels), (*self._walks, *self._kernels)

    def _compile(self) -> None:
        room = self._new_workspace().room
        try:
            digest = digest_of(self._made_of)
            compile_once(self._loop, digest, (room, new_record(1), np.uint64(0)))
        except AcoexpError:
            raise
        except Exception as problem:
            raise failures.not_compiled(self.settings, problem) from problem

    def _new_workspace(self, stop: NDArray[np.uint8] | None = None) -> Workspace:
        stop = np.zeros(1, dtype=np.uint8) if stop is None else stop
        return new_workspace(self._ends, self._kernels.post is not None, stop)


def _moves(trails: Trails, row: int) -> NDArray[np.uint8]:
    return trails.moves[row, : trails.steps[row]].copy()
