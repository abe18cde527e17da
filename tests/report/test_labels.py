"""Names in pictures are drawn as they are, whatever matplotlib would read into them."""

from __future__ import annotations

import warnings

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from acoexp.report.labels import any_signs, as_it_is

NAMES = ["$^$", "$x$", "${b}", "$${b}", r"\$", r"a\$b$c", "$", "a_b^c", "%s", r"\alpha", "{", "_x", "中"]


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_drawn_as_it_is(name: str) -> None:
    figure = Figure()
    FigureCanvasAgg(figure)
    text = figure.text(0.5, 0.5, as_it_is(name))
    assert text._preprocess_math(text.get_text()) == (name, False)


def test_a_sign_that_the_font_has_not_is_no_warning_and_others_stay() -> None:
    figure = Figure()
    figure.text(0.5, 0.5, "中")
    with warnings.catch_warnings(record=True) as caught, any_signs():
        warnings.simplefilter("always", DeprecationWarning)
        FigureCanvasAgg(figure).draw()
        warnings.warn("of another kind", DeprecationWarning, stacklevel=1)
    assert [str(one.message) for one in caught] == ["of another kind"]
