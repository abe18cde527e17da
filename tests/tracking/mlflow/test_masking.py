"""Addresses without their secrets, wherever these stand and whatever they hold."""

from __future__ import annotations

import pytest

from acoexp.tracking.mlflow.masking import masked


@pytest.mark.parametrize(
    ("address", "shown"),
    [
        ("postgresql://me:secret@server/runs", "postgresql://***@server/runs"),
        ("postgresql+psycopg://me:s3c@ret@server/runs", "postgresql+psycopg://***@server/runs"),
        ("postgresql://me:sec/ret@server/runs", "postgresql://***@server/runs"),
        ("postgresql://me:@sec?r#e/t@@server:5432/runs", "postgresql://***@server:5432/runs"),
        ("postgresql://me:a secret@server/runs", "postgresql://***@server/runs"),
        ("http://token@server:5000", "http://***@server:5000"),
        ("http://server:5000/?token=secret", "http://server:5000/?token=***"),
        ("http://server/a?x=1&access_token=secret&y=2", "http://server/a?x=1&access_token=***&y=2"),
        ("postgresql://server/runs?user=me&password=sec@ret", "postgresql://server/runs?user=me&password=***"),
        ("http:/me:secret@server", "http:/***@server"),
        ("http:me:secret@server", "***@server"),
        ("me:secret@server", "***@server"),
        ("//me:secret@server/runs", "//***@server/runs"),
        ("htp://me:secret@server", "htp://***@server"),
        ("postgresql:/me:sec@ret@server/runs", "postgresql:/***@server/runs"),
        ("mysql://me:secret@server/runs?sslpassword=other", "mysql://***@server/runs?sslpassword=***"),
    ],
)
def test_an_address_is_shown_without_its_secrets(address: str, shown: str) -> None:
    assert masked(address, address) == shown
    assert masked(f"{address} is away", address) == f"{shown} is away"


@pytest.mark.parametrize(
    "key", ["password", "passwd", "pwd", "token", "api_key", "apikey", "API-KEY", "secret", "client_secret",
            "access_token", "access_key", "X-Amz-Signature", "X-Amz-Credential", "auth", "sig", "pass",
            "passphrase", "pw", "jwt", "odbc_connect"],
)  # fmt: skip
def test_whatever_a_secret_is_called_it_is_masked(key: str) -> None:
    assert masked(f"http://server/?a=1&{key}=s3cret") == f"http://server/?a=1&{key}=***"
    assert (
        masked(f"connection to host=server {key}=s3cret failed") == f"connection to host=server {key}=*** failed"
    )


@pytest.mark.parametrize(
    "text",
    [
        "sqlite:////home/me@work/outputs/mlflow.db",
        "sqlite:///C:/me@work/mlflow.db?timeout=30",
        "file:///home/me@work/artifacts",
        "http://server:5000/runs",
        "postgresql://server/runs?sslmode=require",
        "the author is me@work.org; see http://server, or ask you@work.org",
    ],
)
def test_what_holds_no_secret_is_left_alone(text: str) -> None:
    assert masked(text, text) == text


def test_the_beginning_of_an_address_that_a_message_cuts_off_is_masked() -> None:
    said = "tracking.uri: expected an address; got 'postgresql://me:hunter2hunter2hunt... (350 characters)"
    assert masked(said) == "tracking.uri: expected an address; got 'postgresql://***... (350 characters)"


def test_a_piece_of_a_password_that_an_error_took_for_a_server_is_masked() -> None:
    address = "postgresql://me:p4ss@word/x@server/runs"
    said = "could not translate host name \"word\" to address, user 'me' with 'p4ss@word/x', password words"
    assert masked(said, address) == (
        "could not translate host name \"***\" to address, user 'me' with '***', password words"
    )


def test_a_password_is_masked_as_it_is_meant_and_as_it_is_written() -> None:
    address = "postgresql://me:p%40ss%2Fword@server/runs"
    assert masked(address, address) == "postgresql://***@server/runs"
    assert masked("refused p@ss/word, p%40ss%2Fword and word", address) == "refused ***, *** and ***"


def test_a_user_or_a_server_of_the_address_is_no_secret_where_it_stands_alone() -> None:
    address = "postgresql://acoexp@server/acoexp"
    assert masked('role "acoexp" of server does not exist', address) == 'role "acoexp" of server does not exist'


def test_what_stands_around_an_address_stays() -> None:
    said = "got 'http://me:one@server/?token=two'; type \"http://me:one@server/?token=two\", (token=two)."
    shown = "got 'http://***@server/?token=***'; type \"http://***@server/?token=***\", (token=two)."
    assert masked(said) == shown


def test_several_addresses_in_one_text_are_masked() -> None:
    text = "tracking:\n  uri: http://me:one@server/x\nmap:\n  path: http://me:two@server/y?token=three\n"
    assert masked(text) == "tracking:\n  uri: http://***@server/x\nmap:\n  path: http://***@server/y?token=***\n"


@pytest.mark.parametrize(
    "slip", ["http:/me:secret", "http:me:secret", "me:secret", "//me:secret", "postgres:/me:secret"]
)
@pytest.mark.parametrize("before", ["tracking.uri=", "  uri: ", "tracking.uri='"])
def test_an_address_with_a_slip_is_masked_where_it_is_given(slip: str, before: str) -> None:
    assert "secret" not in masked(f"{before}{slip}@server/runs")
    assert masked(f"{before}sqlite:////home/me@work/a:b@c.db") == f"{before}sqlite:////home/me@work/a:b@c.db"
