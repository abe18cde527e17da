"""Quoting: whatever a text holds, Hydra and a shell hand it on as it is."""

from __future__ import annotations

import os
import subprocess

import pytest
from hydra.core.override_parser.overrides_parser import OverridesParser
from hypothesis import example, given, settings
from hypothesis import strategies as st
from omegaconf import OmegaConf

from acoexp.command.options.quoting import hydra_text, literal, shell_word

PARSER = OverridesParser.create()
SIGNS = "ab\\\"'${}=,[]() \t\n:~#`!*?|;&ü中"


def as_hydra_takes_it(override: str) -> object:
    """Return the value of an override, parsed and resolved."""
    (parsed,) = PARSER.parse_overrides([override])
    config = OmegaConf.to_container(OmegaConf.create({"k": parsed.value()}), resolve=True)
    assert isinstance(config, dict)
    return config["k"]


@settings(max_examples=300, deadline=None)
@given(st.text(st.sampled_from(SIGNS), max_size=12))
@example("a=b.txt")
@example("a\\'b")
@example("a\\\\'b")
@example("${b}")
@example("\\${b}")
@example("$${b")
@example("2024_05_01")
@example("null")
@example("")
@example("\\")
@example("\\\n")
def test_hydra_takes_a_quoted_text_for_just_this_text(text: str) -> None:
    assert as_hydra_takes_it(f"k={hydra_text(text)}") == text
    assert as_hydra_takes_it(f"k=[{hydra_text(text)}]") == [text]
    assert OmegaConf.to_container(OmegaConf.create(literal({"k": [text, 1]})), resolve=True) == {"k": [text, 1]}


@pytest.mark.parametrize(
    ("text", "quoted"),
    [("a=b", '"a=b"'), ("a'b", '"a\'b"'), ('a"b', "'a\"b'"), ("a\\", '"a\\\\"'), ("${b}", '"\\${b}"')],
)
def test_it_is_quoted_as_a_person_would(text: str, quoted: str) -> None:
    assert hydra_text(text) == quoted


def test_a_shell_hands_a_word_over_as_it_is() -> None:
    words = ["a", "a=b", "a'b", 'a"b', "my map (1)", "$HOME", "`date`", "a!b", "ü中", "~", "*"]
    words += ["a\nb", "\x1b[31m", "a\\'\tb", "\udcff"]
    line = " ".join(map(shell_word, words))
    done = subprocess.run(["bash", "-c", f"printf '%s\\0' {line}"], capture_output=True, check=True)
    assert done.stdout == b"".join(os.fsencode(word) + b"\0" for word in words)
    assert line.isprintable()
