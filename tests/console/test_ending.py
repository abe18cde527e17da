"""How commands end: one line on standard error and a status, or the traceback of what nobody foresaw."""

from __future__ import annotations

from io import BytesIO, TextIOWrapper

import pytest

from acoexp.console.ending import ends_cleanly, print_error
from acoexp.errors import MapError, SettingsError, TrackingError

Capture = pytest.CaptureFixture[str]


def ending(problem: BaseException, capsys: Capture) -> tuple[object, str]:
    """Return the status with which a command ends in which this is raised, and what it says."""
    with pytest.raises(SystemExit) as ended, ends_cleanly("nothing is lost"):
        raise problem
    out, err = capsys.readouterr()
    assert out == ""
    return ended.value.code, err


def test_what_ends_well_says_nothing(capsys: Capture) -> None:
    with ends_cleanly("nothing is lost"):
        print("done")
    assert capsys.readouterr() == ("done\n", "")


@pytest.mark.parametrize(
    "problem",
    [SettingsError("it is wrong"), MapError("it is wrong"), TrackingError("it is wrong"), OSError("it is wrong")],
)
def test_what_is_wrong_is_one_line_and_status_1(problem: Exception, capsys: Capture) -> None:
    assert ending(problem, capsys) == (1, "acoexp: error: it is wrong\n")


def test_a_message_of_many_lines_becomes_one(capsys: Capture) -> None:
    assert ending(OSError("it is\n   wrong\n\nhere "), capsys) == (1, "acoexp: error: it is wrong here\n")


def test_of_the_name_of_a_file_only_so_much_is_shown_as_a_person_reads(capsys: Capture) -> None:
    status, said = ending(OSError(36, "File name too long", "x" * 3000), capsys)
    assert (status, said) == (
        1,
        f"acoexp: error: [Errno 36] File name too long: '{'x' * 199}... (3002 characters)\n",
    )


def test_an_interruption_says_what_was_kept_and_is_the_shells_status(capsys: Capture) -> None:
    assert ending(KeyboardInterrupt(), capsys) == (130, "acoexp: interrupted; nothing is lost\n")
    assert ending(KeyboardInterrupt("all is lost"), capsys) == (130, "acoexp: interrupted; all is lost\n")


def test_what_nobody_foresaw_is_raised_with_its_traceback(capsys: Capture) -> None:
    with pytest.raises(ZeroDivisionError) as caught, ends_cleanly("nothing is lost"):
        1 / 0  # noqa: B018
    assert caught.tb is not None
    assert capsys.readouterr() == ("", "")


def test_a_status_that_was_chosen_within_is_kept(capsys: Capture) -> None:
    assert ending(SystemExit(7), capsys) == (7, "")


def test_a_command_may_have_its_own_words_and_let_through_what_it_likes(capsys: Capture) -> None:
    def words(problem: Exception) -> str | None:
        return "divided by zero" if isinstance(problem, ZeroDivisionError) else None

    with pytest.raises(SystemExit, match="1"), ends_cleanly("", words):
        1 / 0  # noqa: B018
    assert capsys.readouterr().err == "acoexp: error: divided by zero\n"
    with pytest.raises(SettingsError), ends_cleanly("", words):
        raise SettingsError("its traceback is wanted")


def test_an_error_may_be_printed_without_an_end(capsys: Capture) -> None:
    print_error("the store\nis gone")
    assert capsys.readouterr().err == "acoexp: error: the store is gone\n"


def test_a_name_that_the_terminal_cannot_show_ends_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    screen = TextIOWrapper(BytesIO(), encoding="ascii")
    monkeypatch.setattr("sys.stdout", screen)
    with ends_cleanly("nothing is lost"):
        print("Übung", flush=True)
    assert screen.buffer.getvalue() == b"\\xdcbung\n"  # type: ignore[attr-defined]
