"""Tests are found by name: each module has the file of its name, or a line in ``tests/README`` that says which."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]


def modules() -> Iterator[tuple[str, str]]:
    """Yield each module with the file that its name says tests it, both from the root of the checkout."""
    plugins = [(source, source.parents[1] / "tests") for source in ROOT.glob("plugins/*/src/*")]
    for package, tests in ((ROOT / "acoexp", ROOT / "tests"), *plugins):
        for module in package.rglob("*.py"):
            if module.name != "__init__.py":
                test = tests / module.parent.relative_to(package) / f"test_{module.stem.strip('_')}.py"
                yield module.relative_to(ROOT).as_posix(), test.relative_to(ROOT).as_posix()


def lines() -> dict[str, str]:
    """Return the lines of ``tests/README``: each module with the file that tests it."""
    text = (ROOT / "tests" / "README").read_text(encoding="utf-8").partition("\n\n")[2]
    listed = [line.split(": ") for line in text.splitlines()]
    assert len(dict(listed)) == len(listed), "a module stands there twice"
    return dict(listed)


def test_every_module_has_its_test_by_name_or_its_line() -> None:
    without = [module for module, test in modules() if not (ROOT / test).is_file()]
    assert sorted(set(without) - lines().keys()) == []


def test_every_line_names_a_test_that_is_there() -> None:
    assert [test for test in lines().values() if not (ROOT / test).is_file()] == []


def test_no_line_is_of_a_module_that_is_gone_or_has_its_test_by_name() -> None:
    named = dict(modules())
    superfluous = [line for line in lines() if line not in named or (ROOT / named[line]).is_file()]
    assert superfluous == []


def test_lines_stand_in_order() -> None:
    assert list(lines()) == sorted(lines())
