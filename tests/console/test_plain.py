"""What a terminal shows of a text from elsewhere: every sign of it, and none that it would obey."""

from __future__ import annotations

import pytest

from acoexp.console.plain import one_line, printable


@pytest.mark.parametrize("text", ["", "my map (1).txt", "ü 中 🐜", "[b]x[/b] :smile: $^$", "a\\'b"])
def test_what_can_be_seen_stays(text: str) -> None:
    assert printable(text) == text


@pytest.mark.parametrize(
    ("text", "seen"),
    [
        ("\x1b[31mred", r"\x1b[31mred"),
        ("a\rb\tc\nd", r"a\rb\tc\nd"),
        ("\u202egnp.exe", r"\u202egnp.exe"),
        ("\x9b2J", r"\x9b2J"),
        ("\udcff", r"\udcff"),
    ],
)
def test_what_a_terminal_would_obey_is_shown_as_its_escape(text: str, seen: str) -> None:
    assert printable(text) == seen


def test_lines_become_one_and_the_blanks_of_a_name_stay() -> None:
    assert one_line("  it is\n  wrong:\n\n'a  b.txt' ") == "it is wrong: 'a  b.txt'"
    assert one_line("a\x1b[2J\nb") == r"a\x1b[2J b"
