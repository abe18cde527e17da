"""A study of Optuna's: opened or gone on with, asked for values, told what came of them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import yaml

from acoexp.command.options.tuning import TuningKeys
from acoexp.command.tuning.opening import distribution, quiet, sampler_of, storage_at
from acoexp.command.tuning.space import Numbers, Space
from acoexp.console.whole import write_whole
from acoexp.errors import AcoexpError, SettingsError, TrackingError, shown
from acoexp.tracking.mlflow.failures import line_of
from acoexp.tracking.mlflow.masking import masked
from acoexp.tracking.mlflow.store import Store
from acoexp.tracking.open import check_uri

if TYPE_CHECKING:
    import optuna


class Chosen(NamedTuple):
    """A trial of a study: what was chosen, and the number by which the study is told what came of it."""

    number: int
    values: dict[str, Any]


class Study:
    """A study that is open.

    Args:
        keys: Where it is kept, under which name, and what is best.
        sampler: The name of what chooses, and its keys.
        space: What is chosen from.

    Raises:
        SettingsError: if it was begun otherwise, or the sampler cannot choose from this space.
        TrackingError: if its database cannot be reached or written.
    """

    def __init__(self, keys: TuningKeys, sampler: tuple[str, Any], space: Space) -> None:
        self.space = space
        self._store = None if keys.storage is None else _store(keys.storage)
        self._is_grid = sampler[0] == "grid"
        _check_sampler(sampler[0], space)
        with self._reporting(), quiet():
            self._distributions = {key: distribution(values) for key, values in space.keys.items()}
            self._study = self._opened(keys)
            self._check_as_begun(keys)
            self.trials_before = len(self._study.get_trials(deepcopy=False))
            self._study.sampler = sampler_of(*sampler, self.trials_before)

    @property
    def name(self) -> str:
        """Its name, which Optuna makes up where none was given."""
        return str(self._study.study_name)

    def left(self, wanted: int) -> int:
        """Return how many of the trials that are wanted there is something left to choose for."""
        return min(wanted, len(self._untried())) if self._is_grid else wanted

    def ask(self) -> Chosen:
        """Return a further trial."""
        with self._reporting(), quiet():
            if self._is_grid:
                # another process may have tried the last of them
                self._study.enqueue_trial(next(iter(self._untried() or self.space.combinations())))
            trial = self._study.ask(self._distributions)
            return Chosen(trial.number, dict(trial.params))

    def tell(self, trial: Chosen, value: float | None) -> None:
        """Keep what came of a trial.

        Args:
            trial: The trial.
            value: What its job returned; None if it failed. Where no ant arrived that is infinite, and the study
                keeps it as worst of all, which its samplers, that go by order, learn from as from any other.
        """
        from optuna.trial import TrialState

        with self._reporting(), quiet():
            if value is None:
                self._study.tell(trial.number, state=TrialState.FAIL)
            else:
                worst = -math.inf if self._study.direction.name == "MAXIMIZE" else math.inf
                self._study.tell(trial.number, value if math.isfinite(value) else worst)

    def write_best(self, file: Path) -> None:
        """Write the study's best trial into a file, if any is finished: its values, and what its job returned."""
        from optuna.trial import TrialState

        with self._reporting():
            if not self._study.get_trials(deepcopy=False, states=(TrialState.COMPLETE,)):
                return
            best = self._study.best_trial
        found = {"best_params": self.space.plain(best.params), "best_value": best.value}
        write_whole(file, yaml.safe_dump({"name": "optuna", "study_name": self.name, **found}, sort_keys=False))

    def _opened(self, keys: TuningKeys) -> optuna.Study:
        import optuna
        from optuna.study import StudyDirection

        return optuna.create_study(
            storage=None if self._store is None else storage_at(self._store),
            study_name=keys.study_name,
            direction=StudyDirection[keys.direction.upper()],
            load_if_exists=True,
        )

    def _check_as_begun(self, keys: TuningKeys) -> None:
        """Refuse to go on with a study in another direction, or with a key whose values are of another kind."""
        from optuna.distributions import check_distribution_compatibility

        name = f"as study {shown(self.name)} was begun with"
        direction = self._study.direction.name.lower()
        if direction != keys.direction:
            raise SettingsError(f"hydra.sweeper.direction: expected {direction}, {name}; got {keys.direction}")
        before: dict[str, Any] = {}
        for trial in self._study.get_trials(deepcopy=False):
            before.update(trial.distributions)
        for key in before.keys() & self._distributions.keys():
            now = self._distributions[key]
            try:
                check_distribution_compatibility(before[key], now)
            except ValueError:
                raise SettingsError(f"{key}: expected {shown(before[key])}, {name}; got {shown(now)}") from None

    def _untried(self) -> list[dict[str, Any]]:
        """Return the combinations without a finished trial, those that run or failed last."""
        latest: dict[tuple[Any, ...], float] = {}
        for trial in self._study.get_trials(deepcopy=False):
            values = tuple(trial.params.get(key) for key in self.space.keys)
            done = math.inf if trial.state.name == "COMPLETE" else trial.number
            latest[values] = max(latest.get(values, -1), done)
        every = ((latest.get(tuple(one.values()), -1), one) for one in self.space.combinations())
        return [one for _, one in sorted((pair for pair in every if pair[0] < math.inf), key=lambda pair: pair[0])]

    @contextmanager
    def _reporting(self) -> Iterator[None]:
        """Turn what Optuna, SQLAlchemy or the system raise of a database into one error of ours."""
        try:
            yield
        except AcoexpError:
            raise
        except Exception as problem:
            if self._store is None:
                raise
            cause = problem.__cause__ if isinstance(problem.__cause__, Exception) else problem
            raise TrackingError(
                f"hydra.sweeper.storage: expected a database for a study; got {self._store.shown}: "
                f"{masked(line_of(cause), self._store.uri)}"
            ) from problem


def _store(address: str) -> Store:
    return Store(check_uri(address, "hydra.sweeper.storage", "a database"))


def _check_sampler(name: str, space: Space) -> None:
    """Refuse a space that a sampler cannot choose from.

    Raises:
        SettingsError: if so.
    """
    if name == "grid":
        space.check_countable()
    numbers = [key for key, values in space.keys.items() if isinstance(values, Numbers)]
    if name == "cmaes" and len(numbers) < 2:
        raise SettingsError(
            "hydra/sweeper/sampler: cmaes expects intervals or ranges for at least two keys; got "
            f"{' and '.join(numbers) or 'none'}"
        )
