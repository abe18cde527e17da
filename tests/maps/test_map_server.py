"""map_server's YAML and what its modes make of a pixel, held against its rules written out pixel by pixel."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from acoexp import MapError
from acoexp.maps.map_server import Description, free_up_to, occupancy, parse_description

YAML = """image: yard.pgm
resolution: 0.05
origin: [-10.0, 2, 0.5]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""
KEYS = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")
EVERY_GREY = np.dstack([np.arange(256, dtype=np.uint8)[None]] * 3 + [np.full((1, 256), 255, np.uint8)])


def described(**values: Any) -> Description:
    """Return a description with some values other than usual."""
    usual: dict[str, Any] = {"image": "x", "resolution": 1.0, "origin": (0.0, 0.0), "yaw": 0.0, "negate": False}
    return Description(**{**usual, "occupied_thresh": 0.65, "free_thresh": 0.196, **values})


def refusal(text: str) -> str:
    with pytest.raises(MapError) as caught:
        parse_description(text, "yard.yaml")
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 600
    return str(caught.value)


def of_a_pixel(red: int, green: int, blue: int, alpha: int, about: Description) -> int:
    """Return the occupancy of one pixel, as map_server's page tells it."""
    mean = (red + green + blue) / 3
    p = mean / 255 if about.negate else 1 - mean / 255
    if alpha < 255:
        return -1
    if about.mode == "raw":
        return round(mean) if round(mean) <= 100 else -1
    if p >= about.occupied_thresh:
        return 100
    if p <= about.free_thresh:
        return 0
    if about.mode == "trinary":
        return -1
    return round(100 * (p - about.free_thresh) / (about.occupied_thresh - about.free_thresh))


def test_a_description_is_what_its_keys_say() -> None:
    found = parse_description(YAML, "yard.yaml")
    assert (found.image, found.resolution, found.origin, found.yaw) == ("yard.pgm", 0.05, (-10.0, 2.0), 0.5)
    assert (found.negate, found.occupied_thresh, found.free_thresh) == (False, 0.65, 0.196)
    assert found.mode == "trinary"


@pytest.mark.parametrize(
    ("old", "new", "key", "value"),
    [
        ("negate: 0", "negate: 1", "negate", True),
        ("negate: 0", "negate: true", "negate", True),
        ("negate: 0", "negate: no", "negate", False),
        ("0.05", "5e-2", "resolution", 0.05),  # which YAML 1.1 takes as a text
        ("-10.0, 2", "1e-05, -2e-06", "origin", (1e-05, -2e-06)),
        ("yard.pgm", "'a b.png'", "image", "a b.png"),
        ("negate: 0", "negate: 0\nmode: scale", "mode", "scale"),
        ("negate: 0", 'negate: 0\nmode: "raw"\ncost: [1, 2]', "mode", "raw"),
    ],
)
def test_values_may_be_written_as_map_servers_own_reader_takes_them(
    old: str, new: str, key: str, value: Any
) -> None:
    assert getattr(parse_description(YAML.replace(old, new), "yard.yaml"), key) == value


@pytest.mark.parametrize("key", KEYS)
def test_a_key_that_is_missing_is_named(key: str) -> None:
    said = refusal("".join(line for line in YAML.splitlines(keepends=True) if not line.startswith(key)))
    assert said.startswith(f"map yard.yaml: {key}: expected ")
    assert said.endswith("; got nothing")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("0.05", "0", "resolution: expected a number above 0, at most 1e+09; got 0"),
        ("0.05", "-1", "resolution: expected a number above 0, at most 1e+09; got -1"),
        ("0.05", ".nan", "resolution: expected a number above 0, at most 1e+09; got nan"),
        ("0.05", "nan", "resolution: expected a number above 0, at most 1e+09; got nan"),
        ("0.05", ".inf", "resolution: expected a number above 0, at most 1e+09; got inf"),
        ("0.05", "fine", "resolution: expected a number above 0, at most 1e+09; got 'fine'"),
        ("0.05", "9" * 3000, "resolution: expected a number above 0, at most 1e+09; got a number of more than"),
        ("0.05", "[1]", "resolution: expected a number above 0, at most 1e+09; got [1]"),
        ("[-10.0, 2, 0.5]", "[1, 2]", "origin: expected three numbers [x, y, yaw]; got [1, 2]"),
        ("[-10.0, 2, 0.5]", "0", "origin: expected three numbers [x, y, yaw]; got 0"),
        ("[-10.0, 2, 0.5]", "[1, x, 0]", "origin: expected a pair [x, y]; got [1, 'x']"),
        ("[-10.0, 2, 0.5]", "[1, .inf, 0]", "origin: expected a pair [x, y]; got [1, inf]"),
        ("[-10.0, 2, 0.5]", "[1e20, 0, 0]", "origin: expected metres up to 1e+09; got (1e+20, 0.0)"),
        ("[-10.0, 2, 0.5]", "[1, 2, .nan]", "yaw: expected a number from -1000 to 1000; got nan"),
        ("negate: 0", "negate: 2", "negate: expected true or false; got 2"),
        ("negate: 0", "negate: 0\nmode: grey", "mode: expected one of: trinary, scale, raw; got 'grey'"),
        ("yard.pgm", "7", "image: expected a text; got 7"),
        ("0.65", "1.5", "occupied_thresh: expected a number from 0 to 1; got 1.5"),
        ("0.196", "0.65", "free_thresh: expected one below occupied_thresh, 0.65; got 0.65"),
        ("0.196", "0.9", "free_thresh: expected one below occupied_thresh, 0.65; got 0.9"),
    ],
)
def test_a_value_that_is_none_is_named_with_its_key(old: str, new: str, said: str) -> None:
    assert refusal(YAML.replace(old, new)).startswith(f"map yard.yaml: {said}")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "got None"),
        ("P5\n3 2\n255\n", "got 'P5 3 2 255'"),
        ("- image\n", "got ['image']"),
        ("image: [\n", "got \"expected the node content, but found '<stream end>'\" in line 2"),
        ("image: \x07\n", "got what cannot be read"),
        ("resolution: 2020-99-99\n", "got what cannot be read: 'month must be in 1..12"),
        ("x: !!timestamp no\n", "got what cannot be read"),
        ("resolution: " + "9" * 5000, "got what cannot be read: "),
        ("x: !!python/name:os.getcwd\n", 'got "could not determine a constructor'),
        ("x: &x [*x]\n", "got what cannot be read: 'its aliases make it endless, or too large'"),
        ("x: &x [1, 2]\n" + "y: [" + "*x, " * 1000 + "]", "got what cannot be read: 'its aliases make it endless"),
        ("x: " + "[" * 5000, "got what is too deep"),
        ("#" * 70_000, "got 70000 characters, more than 65536"),
    ],
)
def test_what_is_no_description_is_refused(text: str, said: str) -> None:
    assert refusal(text).partition(" and so on; ")[2].startswith(said)


def test_the_usual_grey_of_unknown_is_free_at_a_threshold_of_a_quarter() -> None:
    grey = EVERY_GREY[:, 205:206]
    assert occupancy(grey, described(free_thresh=0.196)).tolist() == [[-1]]
    assert occupancy(grey, described(free_thresh=0.25)).tolist() == [[0]]


@given(
    st.sampled_from(["trinary", "scale", "raw"]),
    st.booleans(),
    st.lists(st.sampled_from([0.0, 0.196, 0.25, 0.5, 0.65, 1.0]), min_size=2, max_size=2, unique=True),
    st.lists(st.tuples(*[st.integers(0, 255)] * 3, st.sampled_from([0, 254, 255, 255, 255])), min_size=1),
)
def test_every_pixel_is_what_map_server_says(
    mode: str, negate: bool, thresholds: list[float], pixels: list[tuple[int, int, int, int]]
) -> None:
    low, high = sorted(thresholds)
    about = described(mode=mode, negate=negate, free_thresh=low, occupied_thresh=high)
    found = occupancy(np.array([pixels], dtype=np.uint8), about)[0]
    expected = np.array([of_a_pixel(*pixel, about) for pixel in pixels])
    assert np.abs(found - expected).max() <= (1 if mode == "scale" else 0)  # of a half it may be either
    assert ((found == -1) == (expected == -1)).all()


def test_thresholds_that_all_but_meet_make_no_trouble() -> None:
    about = described(mode="scale", free_thresh=0.0, occupied_thresh=5e-324)
    assert np.unique(occupancy(EVERY_GREY, about)).tolist() == [0, 100]


def test_in_the_modes_without_unknowns_in_between_only_what_is_vouched_for_is_free() -> None:
    assert free_up_to(described(mode="trinary", free_thresh=0.25)) == 0
    assert free_up_to(described(mode="scale", free_thresh=0.25)) == 0
    assert [free_up_to(described(mode="raw", free_thresh=t)) for t in (0.0, 0.196, 0.29)] == [0, 19, 29]
