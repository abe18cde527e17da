"""Reading overrides: what Hydra would misread is told, with the line to type."""

from __future__ import annotations

import shlex

import pytest

from acoexp.command.options.reading import check_texts, line_to_type, read, takes_text, takes_whole_number
from acoexp.errors import SettingsError


def refusal(override: str, several: bool = False) -> str:
    """Return the message with which an override is refused, when it is read or when its text is looked at."""
    with pytest.raises(SettingsError) as caught:  # noqa: PT012
        read([override], several)
        check_texts([override], several)
    return str(caught.value)


@pytest.mark.parametrize(
    "override",
    [
        "rho=0.5",
        "map.path=yard.txt",
        "map.path='a=b.txt'",
        'map.path="2024"',
        "map.path=null",
        "map.start=[1,2]",
        'report.cells=[aco,"pd ants=3"]',
        "tracking.uri=http://server:5000",
        "hydra.run.dir=outputs/mine",
        "map.moves=1",
        "nope=1",
        "~seed",
        "+study=slow",
    ],
)
def test_what_hydra_reads_as_it_was_meant_is_left_alone(override: str) -> None:
    (parsed,) = read([override])
    check_texts([override], several=False)
    assert parsed.input_line == override


def test_overrides_are_read_in_their_order() -> None:
    assert [parsed.key_or_group for parsed in read(["rho=0.5", "+study=slow", "~seed"])] == [
        "rho",
        "study",
        "seed",
    ]


@pytest.mark.parametrize("override", ["seed", "a b", "a b=1"])
def test_what_is_no_override_is_refused(override: str) -> None:
    assert refusal(override) == f"{override!r}: expected key=value"


@pytest.mark.parametrize(
    ("override", "said"),
    [
        ("rho=a=b", "rho: expected a number from 0 to 1; got 'a=b'"),
        ("rho=${a", "rho: expected a number from 0 to 1; got '${a'"),
        ("map.start=[1,", "map.start: expected a pair [row, column]; got '[1,'"),
        (
            "map=a b(",
            "map: expected one of: env1, env2, fig13, file, image, maze, movingai, random, rectangles, rooms, "
            "ros; got 'a b('",
        ),
        (
            "post=geometrik(",
            "post: expected one of: geometric, none, shortcut; got 'geometrik('; did you mean geometric?",
        ),
    ],
)
def test_what_cannot_be_read_and_is_no_text_is_refused_by_what_is_declared(override: str, said: str) -> None:
    assert refusal(override) == said


@pytest.mark.parametrize(
    ("override", "line"),
    [
        ("map.path=a=b.txt", "'map.path=\"a=b.txt\"'"),
        ("map.path=ü.txt", "'map.path=\"ü.txt\"'"),
        ("map.path=my map (1).txt", "'map.path=\"my map (1).txt\"'"),
        ("tracking.uri=http://me:a=b@server", "'tracking.uri=\"http://me:a=b@server\"'"),
        ("report.cells=[aco,pd ants=3]", "'report.cells=[aco,\"pd ants=3\"]'"),
        ("nope=a=b", "'nope=\"a=b\"'"),
    ],
)
def test_what_cannot_be_read_and_may_be_a_text_is_told_with_the_line_to_type(override: str, line: str) -> None:
    key, _, value = override.partition("=")
    said = f"{key}: expected quotes, as Hydra reads signs in it as its own; got {value}; type {line}"
    assert refusal(override) == said
    (typed,) = shlex.split(line)
    check_texts([typed], several=False)  # and that line is read


@pytest.mark.parametrize(
    ("override", "noun"),
    [
        ("map.path=2024", "a number"),
        ("map.path=1e3", "a number"),
        ("map.path=true", "true or false"),
        ("map.path=[x]", "a list"),
        ("map.path={a:1}", "a mapping"),
        ("+map.path=1", "a number"),
        ("seeds=1_0", "a number"),
        ("hydra.run.dir=2024", "a number"),
    ],
)
def test_a_text_that_hydra_reads_as_something_else_is_told_with_the_line_to_type(override: str, noun: str) -> None:
    key, _, value = override.partition("=")
    said = refusal(override)
    assert said.startswith(f"{key}: expected a text; got {value}, which Hydra reads as {noun}; type ")
    (typed,) = shlex.split(said.partition("; type ")[2])
    check_texts([typed], several=False)


@pytest.mark.parametrize("value", [" a.txt", "a.txt ", "b\\\\"])
def test_a_text_whose_ends_hydra_would_drop_is_told_with_the_line_to_type(value: str) -> None:
    said = refusal(f"map.path={value}")
    assert said.startswith(f"map.path: expected quotes, as Hydra drops signs at its ends; got {value!r}; type ")
    (typed,) = shlex.split(said.partition("; type ")[2])
    check_texts([typed], several=False)
    assert read([typed])[0].value() == value


@pytest.mark.parametrize("values", ["choice(a,2024)", "a,2024"])
def test_each_text_of_a_sweep_is_looked_at(values: str) -> None:
    said = refusal(f"map.path={values}", several=True)
    assert said.startswith(f"map.path: expected a text; got {values}, which Hydra reads as a number; type ")


def test_what_a_pattern_stands_for_only_hydra_knows() -> None:
    check_texts(["map.path=glob(*)"], several=True)


@pytest.mark.parametrize(
    ("override", "said"),
    [
        ("hydra.run.dir='~/mine'", "expected a folder; got ~/mine, which Hydra would make in this one; type "),
        ("hydra.run.dir=null", "expected a folder; got null"),
        ("hydra.sweep.subdir=null", "expected a folder; got null"),
        ("hydra.sweep.dir=~/mine", "expected quotes, as Hydra reads signs in it as its own; got ~/mine; type "),
        (
            r"hydra.sweep.dir='\${x}'",
            "expected a folder without '${' in its name, by which Hydra refers to keys; ",
        ),
    ],
)
def test_a_folder_that_hydra_would_take_for_another_is_refused(
    override: str, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", "/home/me")
    refused = refusal(override)
    assert refused.startswith(f"{override.partition('=')[0]}: {said}")
    if "; type " in refused:
        assert refused.endswith('="/home/me/mine"\'')


@pytest.mark.parametrize(
    ("key", "takes"),
    [
        ("map.path", True),
        ("tracking.uri", True),
        ("+tracking.uri", True),
        ("seeds", True),
        ("hydra.sweep.subdir", True),
        ("map.moves", False),
        ("order", False),
        ("rho", False),
        ("report.cells", False),
        ("nope", False),
    ],
)
def test_keys_of_texts_are_known_from_their_declarations(key: str, takes: bool) -> None:
    assert takes_text(key) is takes


@pytest.mark.parametrize(
    ("key", "takes"),
    [
        ("seed", True),
        ("+seed", True),
        ("ants", True),
        ("map.seed", True),
        ("map.instance", True),
        ("map.path", False),
        ("map.size", False),
        ("rho", False),
        ("map.density", False),
        ("resume", False),
        ("seeds", False),
        ("nope", False),
    ],
)
def test_keys_of_whole_numbers_are_known_from_their_declarations(key: str, takes: bool) -> None:
    assert takes_whole_number(key) is takes


@pytest.mark.parametrize(
    ("key", "value", "several", "line"),
    [
        ("map.path", "'2024'", False, "'map.path=\"2024\"'"),
        ("map.path", "a,2024", True, '\'map.path="a","2024"\''),
        ("map.path", "a,2024", False, "'map.path=\"a,2024\"'"),
        ("map.path", "~/yard.txt", False, "'map.path=\"/home/me/yard.txt\"'"),
        ("report.cells", "[aco, pd ants=3]", False, "'report.cells=[aco,\"pd ants=3\"]'"),
        ("map.path", "[x]", False, "'map.path=\"[x]\"'"),
        ("map.path", "x" * 201, False, "map.path='\"...\"'"),
    ],
)
def test_the_line_to_type_says_the_text_that_was_meant(
    key: str, value: str, several: bool, line: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", "/home/me")
    assert line_to_type(key, value, several) == line
