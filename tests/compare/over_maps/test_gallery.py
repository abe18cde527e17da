"""Pictures over maps: those that show something, each with what it shows."""

from __future__ import annotations

from pathlib import Path

import pytest
from compared import maps_of

from acoexp.compare.over_maps.budgets import UNITS, anytime
from acoexp.compare.over_maps.gallery import draw_over_maps
from acoexp.compare.over_maps.pooling import effect_row
from acoexp.compare.over_maps.values import values_of_maps
from acoexp.compare.over_maps.verdict import verdict_over


@pytest.mark.parametrize(
    ("maps", "labels", "expected"),
    [
        (1, "abc", ["targets", "budgets"]),
        (2, "abc", ["effects", "profiles", "targets", "budgets"]),
        (6, "ab", ["effects", "profiles", "targets", "budgets"]),
        (6, "abc", ["ranks", "effects", "profiles", "targets", "budgets"]),
    ],
)
def test_what_there_is_to_be_shown_is_drawn(maps: int, labels: str, expected: list[str], tmp_path: Path) -> None:
    made = maps_of([[0.1, 0.2, 0.3][: len(labels)]] * maps, labels)
    values = values_of_maps(made)
    effects = [effect_row(of_map[n], of_map[0]) for n in range(1, len(labels)) for of_map in made]
    reached = [anytime(made, unit, inference=False) for unit in UNITS]
    found = draw_over_maps(tmp_path, values, verdict_over(made, values), effects, reached)
    assert [picture.name for picture in found] == expected
    assert {path.name for path in tmp_path.iterdir()} == {
        f"{name}.{e}" for name in expected for e in ("svg", "png")
    }
    assert all(picture.note.endswith(".") for picture in found)
