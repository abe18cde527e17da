"""Failures: what is said of a trial that came to no result, with the part at fault and its package."""

from __future__ import annotations

from typing import Any

from acoexp.colony import diagnosis
from acoexp.colony.verdicts import NO_PATH, STOPPED, UNSOUND
from acoexp.errors import AcoexpError, StrategyError
from acoexp.trial.settings import Settings


def check(settings: Settings, moves: str, seed: int, verdict: int) -> None:
    """Blame the part that broke its contract in a trial, if one did.

    Args:
        settings: Its settings.
        moves: The rule for diagonals.
        seed: Its seed.
        verdict: What the loop returned.

    Raises:
        StrategyError: if a part broke its contract.
        AcoexpError: if the trial was stopped.
    """
    if verdict > 0:
        raise StrategyError(
            f"{culprit(settings, 'post')} broke its contract, seed {seed}, cycle {verdict}: "
            "what the post-optimiser returned is no path from start to goal; expected allowed moves"
        )
    if verdict == UNSOUND:
        raise StrategyError(
            f"{suspects(settings)} broke its contract, seed {seed}: it made pheromone "
            "negative or not a number; expected numbers, at least 0"
        )
    if verdict == STOPPED:
        raise AcoexpError(f"seed {seed} was stopped")
    if verdict == NO_PATH:
        raise StrategyError(
            f"{culprit(settings, 'choice')} broke its contract, seed {seed}: an ant made moves "
            f"that are not allowed under the rule {moves!r}; expected an open one, or LOST"
        )


def not_compiled(settings: Settings, problem: Exception) -> StrategyError:
    """Return the error for a colony that cannot be compiled: the part at fault, why, and the author's line."""
    foreign, text = _foreign(settings), str(problem)
    places = {}
    for group in foreign:
        part = settings.parts[group]
        functions = [part.kernel.py_func, *diagnosis.compiled_functions(type(part))]
        places[group] = diagnosis.place_of(problem, diagnosis.sources_of(part), functions)
    faulty = (
        [group for group in foreign if repr(settings.parts[group].kernel.py_func) in text]
        or [group for group in foreign if places[group] is not None]
        or foreign
    )
    who = " or ".join(map(settings.describe, faulty)) or _colony(settings)
    place = next((places[group] for group in faulty if places[group] is not None), None)
    return StrategyError(f"{who} cannot be compiled: {diagnosis.explain(problem)}{diagnosis.at(place)}")


def raised(settings: Settings, seed: int, problem: BaseException) -> StrategyError:
    """Return the error for a kernel that raised, which kernels may not do."""
    foreign = _foreign(settings)
    places = {
        group: diagnosis.raised_at(problem, diagnosis.sources_of(settings.parts[group])) for group in foreign
    }
    group = next((group for group in foreign if places[group] is not None), None)
    who = f"a kernel of {_colony(settings)}" if group is None else f"the kernel of {settings.describe(group)}"
    at = f"; {suspects(settings)}" if group is None and foreign else diagnosis.at(places.get(group or ""))
    return StrategyError(f"{who} raised, seed {seed}: {type(problem).__name__}: {problem}{at}")


def suspects(settings: Settings) -> str:
    """Return the words for the parts one of which broke the contract: those that are not built in, and tested."""
    foreign = _foreign(settings)
    who = " or ".join(map(settings.describe, foreign or _acting(settings)))
    return f"most likely {who}" if foreign else who


def culprit(settings: Settings, group: str) -> str:
    """Return the words for the part that broke the contract, if it came to light in the part of this group.

    A kernel that writes where it may not makes others fail.
    """
    foreign = _foreign(settings)
    if group in foreign or not foreign:
        return settings.describe(group)
    return f"{suspects(settings)} ({settings.describe(group)} is built in)"


def _acting(settings: Settings) -> list[str]:
    """Return the groups whose part acts while a trial runs."""
    return [group for group, part in settings.parts.items() if getattr(part, "kernel", None) is not None]


def _foreign(settings: Settings) -> list[str]:
    """Return those whose part is not a built-in one."""
    return [group for group in _acting(settings) if not _is_ours(settings.parts[group])]


def _is_ours(part: Any) -> bool:
    return type(part).__module__.partition(".")[0] == __name__.partition(".")[0]


def _colony(settings: Settings) -> str:
    parts = []
    for group, chosen in settings.chosen.items():
        foreign = chosen.package is not None and not _is_ours(chosen.part)
        parts.append(f"{group}={chosen.name}" + (f" of {chosen.package}" if foreign else ""))
    return f"the colony ({', '.join(parts)})"
