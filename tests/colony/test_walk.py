"""The ants of a cycle walk one after another, or in lock step; each has its own tabu."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from samples import colony_on, problem_on, room_of

from acoexp import Grid
from acoexp.colony.compiled import compiled
from acoexp.colony.state import BACK, LOST, NO_WAY_HERE
from acoexp.colony.walk import in_turn, lock_step
from acoexp.strategies.choice.roulette import spin
from acoexp.strategies.diffusion.none import stay

ORDERS = {"in_turn": in_turn, "lock_step": lock_step}
CORRIDOR = Grid([[0, 0, 0, 0]], start=(0, 0), goal=(0, 3))
RING = Grid([[0, 0, 0], [0, 1, 0], [0, 0, 0]], start=(0, 0), goal=(2, 2), moves="no_cut")


BETWEEN = Grid([[0, 0, 0, 0, 0]], start=(0, 2), goal=(0, 4))
"""East the goal, west a dead end."""


class Diary(NamedTuple):
    """Room for what ``note`` writes down."""

    entries: NDArray[np.int64]
    pages: NDArray[np.int64]


@compiled
def note(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Write down who walks, where it is and where it came from."""
    page = own.pages[own.entries[0]]
    page[0], page[1], page[2] = ant, cell, came
    own.entries[0] += 1


@compiled
def go_south(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    return 6


@compiled
def think_better_of_it(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    return 0 if cell == colony.start else BACK


@compiled
def go_nowhere(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    return 2**32


@compiled
def go_below(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    return -(2**40)


@compiled
def go_to_and_fro(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    return 0 if came == NO_WAY_HERE or came == 4 else 4


def walked(
    order: str,
    grid: Grid,
    ants: int,
    choose: Any = spin,
    diffuse: Any = stay,
    own: Any = (),
    steps_back: bool = False,
    **settings: Any,
) -> Any:
    """Let the ants of one cycle walk: whether they kept to the contract, their trails, and the colony."""
    room = room_of(colony_on(problem_on(grid, ants=ants, **settings)), diffusion=own)
    assert room.crowd is not None
    walk_together, walk = ORDERS[order](choose, diffuse, steps_back)
    with np.errstate(over="ignore"):
        sound = walk_together(room)
        sound = all([sound, *(walk(room, ant) for ant in range(ants))])
    assert (room.colony.untouched == 1.0).all()  # nothing is tabu any more, whatever happened
    assert (room.crowd.untouched == 1.0).all()
    return sound, room.raw, room.colony


@pytest.mark.parametrize(("order", "ants"), [("in_turn", [0, 0, 0, 1, 1, 1]), ("lock_step", [0, 1, 0, 1, 0, 1])])
def test_whose_turn_it_is(order: str, ants: list[int]) -> None:
    diary = Diary(np.zeros(1, dtype=np.int64), np.zeros((10, 3), dtype=np.int64))
    sound, trails, colony = walked(order, CORRIDOR, ants=2, diffuse=note, own=diary)
    assert sound
    assert trails.length.tolist() == [3.0, 3.0]
    pages = diary.pages[: diary.entries[0]]
    assert pages[:, 0].tolist() == ants
    for ant in (0, 1):
        ways = [[colony.start, NO_WAY_HERE], [colony.start + 1, 0], [colony.start + 2, 0]]
        assert pages[pages[:, 0] == ant, 1:].tolist() == ways


@pytest.mark.parametrize("order", ORDERS)
def test_no_ant_is_kept_from_where_another_has_been(order: str) -> None:
    """In a corridor all go the same way; on a ring, where none can turn back, some go left and some right."""
    sound, trails, _ = walked(order, RING, ants=30)
    assert sound
    assert trails.length.tolist() == [4.0] * 30
    assert {tuple(moves) for moves in trails.moves[:, :4].tolist()} == {(0, 0, 6, 6), (6, 6, 0, 0)}
    assert trails.straight.tolist() == trails.steps.tolist() == [4] * 30


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(
    "choose",
    [go_south, go_nowhere, go_below],
    ids=["into a wall", "a number that wraps around to east", "a number below all directions"],
)
def test_a_choice_that_breaks_its_contract_is_noticed(choose: Any, order: str) -> None:
    sound, trails, _ = walked(order, CORRIDOR, ants=2, choose=choose)
    assert not sound
    assert np.isinf(trails.length).all()


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(("choose", "steps"), [(go_to_and_fro, 18), (think_better_of_it, 0)])
@pytest.mark.parametrize("max_steps", [None, 10**9])
def test_an_ant_that_never_comes_to_an_end_is_lost(
    choose: Any, steps: int, max_steps: int | None, order: str
) -> None:
    sound, trails, colony = walked(order, CORRIDOR, ants=2, choose=choose, max_steps=max_steps)
    assert colony.allowed.size == 18
    assert sound
    assert np.isinf(trails.length).all()
    assert trails.steps.tolist() == [steps] * 2


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(("max_steps", "arrives"), [(4, True), (3, False), (1, False)])
def test_an_ant_that_made_so_many_moves_as_it_may_is_lost_and_its_way_is_there(
    max_steps: int, arrives: bool, order: str
) -> None:
    sound, trails, _ = walked(order, RING, ants=4, max_steps=max_steps)
    assert sound
    assert np.isfinite(trails.length).tolist() == [arrives] * 4
    assert trails.steps.tolist() == trails.straight.tolist() == [max_steps] * 4
    assert {tuple(moves) for moves in trails.moves[:, :max_steps].tolist()} <= {
        (0, 0, 6, 6)[:max_steps],
        (6, 6, 0, 0)[:max_steps],
    }


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(("max_steps", "length"), [(6, 2.0), (5, np.inf)])
def test_moves_back_count(max_steps: int, length: float, order: str) -> None:
    """Two moves west and back, then two east."""
    _, trails, _ = walked(order, BETWEEN, ants=1, choose=look_far_west_first, steps_back=True, max_steps=max_steps)
    assert trails.length.tolist() == [length]


@compiled
def look_far_west_first(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    """Go west as far as it gets, then back and east."""
    if cell <= colony.start and colony.untouched[cell - 1] == 1.0 and colony.allowed[cell] >> 4 & 1:
        return 4
    return LOST if cell < colony.start else 0


@compiled
def look_west_first(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    """Go a step west, say that this leads nowhere, and go east."""
    if cell == colony.start:
        return 4 if colony.untouched[cell - 1] == 1.0 else 0
    return BACK if cell < colony.start else 0


@compiled
def give_up(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    return BACK


@pytest.mark.parametrize("order", ORDERS)
def test_at_a_dead_end_an_ant_is_lost(order: str) -> None:
    sound, trails, _ = walked(order, BETWEEN, ants=40)
    assert sound
    assert {*zip(trails.moves[:, 0].tolist(), trails.length.tolist(), strict=True)} == {(0, 2.0), (4, np.inf)}


@pytest.mark.parametrize("order", ORDERS)
def test_or_it_steps_back_and_goes_on_where_it_has_not_been(order: str) -> None:
    diary = Diary(np.zeros(1, dtype=np.int64), np.zeros((400, 3), dtype=np.int64))
    sound, trails, colony = walked(order, BETWEEN, ants=40, diffuse=note, own=diary, steps_back=True)
    assert sound
    assert trails.length.tolist() == [2.0] * 40
    assert trails.straight.tolist() == trails.steps.tolist() == [2] * 40
    assert trails.moves[:, :2].tolist() == [[0, 0]] * 40
    pages = diary.pages[: diary.entries[0]]
    ways = {tuple(map(tuple, (pages[pages[:, 0] == ant, 1:] - [colony.start, 0]).tolist())) for ant in range(40)}
    straight = ((0, NO_WAY_HERE), (1, 0))
    assert ways == {straight, ((0, NO_WAY_HERE), (-1, 4), (-2, 4), (-1, 4), *straight)}


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("steps_back", [False, True])
def test_a_choice_may_say_itself_that_the_ant_goes_back(steps_back: bool, order: str) -> None:
    sound, trails, _ = walked(order, BETWEEN, ants=2, choose=look_west_first, steps_back=steps_back)
    assert sound
    assert trails.moves[:, :2].tolist() == [[0, 0]] * 2


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("steps_back", [False, True])
def test_an_ant_that_has_given_all_its_moves_back_is_lost(steps_back: bool, order: str) -> None:
    sound, trails, _ = walked(order, BETWEEN, ants=2, choose=give_up, steps_back=steps_back)
    assert sound
    assert np.isinf(trails.length).all()
    assert trails.steps.tolist() == [0, 0]
