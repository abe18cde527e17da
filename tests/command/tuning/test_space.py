"""The space of a study: what each override leaves the choice of, and what jobs are told."""

from __future__ import annotations

from typing import Any

import pytest
from hydra.core.override_parser.overrides_parser import OverridesParser

from acoexp.command.tuning.space import Choice, Numbers, Space
from acoexp.errors import SettingsError


def space(*overrides: str) -> Space:
    """Return the space that overrides describe."""
    return Space(OverridesParser.create().parse_overrides(list(overrides)))


@pytest.mark.parametrize(
    ("override", "values"),
    [
        ("k=interval(0.1,0.9)", Numbers(0.1, 0.9)),
        ("k=interval(1,8)", Numbers(1.0, 8.0)),
        ("k=int(interval(1,8))", Numbers(1, 8, step=1)),
        ("k=tag(log,interval(1e-3,1))", Numbers(0.001, 1.0, log=True)),
        ("k=tag(log,int(interval(1,100)))", Numbers(1, 100, log=True)),
        ("k=range(1,10)", Numbers(1, 9, step=1)),
        ("k=range(1,10,3)", Numbers(1, 7, step=3)),
        ("k=range(10,1,-3)", Numbers(4, 10, step=3)),
        ("k=range(0.1,0.5,0.1)", Numbers(0.1, 0.4, step=0.1)),
        ("k=choice(aco,pd)", Choice(("aco", "pd"))),
        ("k=aco,'a,b',aco", Choice(("aco", "'a,b'"))),
    ],
)
def test_what_an_override_leaves_the_choice_of(override: str, values: Numbers | Choice) -> None:
    found = space(override).keys["k"]
    assert found == values
    assert [type(end) for end in found.ends] == [type(end) for end in values.ends]


@pytest.mark.parametrize(
    ("override", "numbers"),
    [
        ("k=range(1,10,3)", [1, 4, 7]),
        ("k=range(10,1,-3)", [4, 7, 10]),
        ("k=range(0,1,0.1)", [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]),
    ],
)
def test_a_range_has_the_numbers_that_it_has_everywhere_in_hydra(override: str, numbers: list[Any]) -> None:
    (parsed,) = OverridesParser.create().parse_overrides([override])
    assert sorted(map(float, parsed.sweep_string_iterator())) == pytest.approx(numbers)
    found = space(override).keys["k"]
    assert [*found] == numbers
    assert len(found) == len(numbers)
    assert [type(number) for number in found] == [type(number) for number in numbers]


def test_what_leaves_no_choice_is_told_to_every_job() -> None:
    found = space(
        "rho=interval(0,1)", "algo=pd", "diffusion.gamma=choice(0.5)", "ants=range(3,4)", "seeds='0-9,20'"
    )
    assert [*found.keys] == ["rho"]
    told = ["algo=pd", "diffusion.gamma=0.5", "ants=3", "seeds='0-9,20'"]
    assert found.told({"rho": 1e-05}) == ["rho=1e-05", *told]


def test_of_a_key_that_is_given_twice_the_last_one_counts() -> None:
    assert space("rho=interval(0,1)", "ants=1,2", "rho=0.5").fixed == ["rho=0.5"]


def test_a_few_samples_have_each_choice_and_both_ends() -> None:
    found = space("rho=interval(0.1,0.9)", "algo=aco,pd,pdg", "ants=range(1,5)", "map=env2")
    assert found.samples() == [
        ["rho=0.1", "algo=aco", "ants=1", "map=env2"],
        ["rho=0.9", "algo=pd", "ants=4", "map=env2"],
        ["rho=0.9", "algo=pdg", "ants=4", "map=env2"],
    ]


def test_combinations_change_in_the_last_key_fastest() -> None:
    every = [*space("algo=aco,pd", "ants=range(1,3)").combinations()]
    assert every == [{"algo": a, "ants": n} for a in ("aco", "pd") for n in (1, 2)]


def test_a_text_that_was_chosen_is_what_hydra_reads() -> None:
    found = space("q=true,false", "n=1,2", "t='1','2'", "rho=interval(0,1)")
    chosen = {"q": "true", "n": "2", "t": "'1'", "rho": 0.5, "of_an_earlier_command": "true"}
    assert found.plain(chosen) == {"q": True, "n": 2, "t": "1", "rho": 0.5, "of_an_earlier_command": "true"}


@pytest.mark.parametrize(
    ("override", "said"),
    [
        ("k=interval(0.9,0.1)", "expected interval(low,high), from a number to one that is no smaller"),
        ("k=interval(0,inf)", "expected interval(low,high), from a number to one that is no smaller"),
        ("k=interval(nan,1)", "expected interval(low,high), from a number to one that is no smaller"),
        ("k=tag(log,interval(0,1))", "expected numbers above 0 with a log"),
        ("k=tag(log,range(1,9,2))", "expected a range by steps of 1 with a log"),
        ("k=range(9,1)", "expected range(start,stop,step) with at least one number in it"),
        ("k=range(1,9,0)", "expected range(start,stop,step) with at least one number in it"),
        ("k=range(0,inf)", "expected range(start,stop,step) with at least one number in it"),
        ("k=range(0,1,nan)", "expected range(start,stop,step) with at least one number in it"),
        ("k=int(interval(0,1e17))", "expected whole numbers of at most 9007199254740992"),
    ],
)
def test_a_space_with_nothing_in_it_is_refused(override: str, said: str) -> None:
    with pytest.raises(SettingsError) as caught:
        space(override)
    assert str(caught.value) == f"{override}: {said}"


def test_without_a_choice_there_is_no_study() -> None:
    with pytest.raises(SettingsError, match="expects a key to choose values for"):
        space("rho=0.5")


def test_only_so_many_combinations_are_all_tried() -> None:
    space("ants=range(0,100000)").check_countable()
    with pytest.raises(SettingsError, match="expected at most 100000 combinations with grid; got 200000"):
        space("ants=range(0,100000)", "algo=aco,pd").check_countable()
    with pytest.raises(SettingsError, match="rho: expected values or a range"):
        space("rho=interval(0,1)", "algo=aco,pd").check_countable()
