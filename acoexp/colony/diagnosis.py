"""Diagnosis: what the compiler says of a kernel, in words of its author's, and the author's own line.

numba tells its errors from the inside out: the innermost place comes first, and the loop that all kernels are
compiled into comes last. The first place in a file of the author's is what the author can mend.
"""

from __future__ import annotations

import dis
import linecache
import re
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from acoexp.colony.state import Colony
from acoexp.errors import AcoexpError, StrategyError, did_you_mean

_PLACE = re.compile(r" at (/\S.*|[A-Za-z]:\\.*|<.*) \((\d+)\)$", re.M)
_WRONG_CALL = re.compile(
    r"Cannot bind .* due to \"TypeError: (.+)\"\.\n.*<function (?:\w+\.<locals>\.)*(\w+) at", re.M
)
_WORDS: dict[str, Callable[[re.Match[str]], str]] = {
    r"Cannot modify readonly array": lambda _: (
        "it writes to an array that is read-only; an array of its own is made writable by .copy() in prepare"
    ),
    r"\A(No implementation of function Function\(<class 'bool'>\))": lambda _: (
        "an array stands where a number is expected"
    ),
    r"NRT required but not enabled|Only accept returning of array|'str'>\) found for": lambda _: (
        "a kernel must not allocate memory (new arrays, lists, texts), prepare may"
    ),
    r"Unknown attribute '(\w+)' of type Colony": lambda m: (
        f"colony has no {m[1]!r}{did_you_mean(m[1], Colony._fields)}"
    ),
    r"Unknown attribute '(\w+)' of type (Uni)?Tuple": lambda m: (
        f"a tuple has no {m[1]!r}; expected prepare to return a NamedTuple, or own[0], own[1], ..."
    ),
    r"Unknown attribute '(\w+)' of type (\w+)\(": lambda m: f"{m[2]} has no {m[1]!r}",
    _WRONG_CALL.pattern: lambda m: f"{m[2]} is not called with what it takes: {m[1]}",
    r"Untyped global name '(\w+)':.*<class 'function'>": lambda m: f"it calls {m[1]}, which is not @compiled",
    r"No definition for lowering Colony\.(\w+) = ": lambda m: f"colony.{m[1]} cannot be replaced, only read",
    r"No implementation of function Function.*\n\s*>>> (.*)": lambda m: f"the compiler knows no {m[1]}",
}
"""What numba says, as a pattern, and what it is called here; the first that is found counts."""


class Place(NamedTuple):
    """A line of source."""

    file: str
    line: int

    def __str__(self) -> str:
        source = linecache.getline(self.file, self.line).strip()
        return f"{self.file}:{self.line}" + (f": {source}" if source else "")


def explain(problem: BaseException) -> str:
    """Return in one line what is wrong with a kernel that cannot be compiled."""
    text = _shortened(str(problem))
    for pattern, words in _WORDS.items():
        found = re.search(pattern, text, re.M)
        if found:
            return words(found)
    return text.partition("\n")[0] or type(problem).__name__


def place_of(problem: BaseException, files: Iterable[Path], functions: Iterable[Any]) -> Place | None:
    """Return the author's own innermost line at which a kernel cannot be compiled; None if nobody knows.

    Args:
        problem: The compiler's error.
        files: The author's source files, and folders of them.
        functions: The author's compiled functions, searched for a name where the compiler tells no line.
    """
    text, folders = str(problem), list(files)
    for file, line in _PLACE.findall(text):
        if _is_in(file, folders):
            return Place(file, int(line))
    named = re.search(r"(?:name|attribute) '(\w+)'", text) or re.search(r"\)\.(\w+) = ", text)
    if named is None:
        return None
    candidates = [function for function in functions if _is_in(function.__code__.co_filename, folders)]
    candidates.sort(key=lambda function: repr(function) not in text)
    return next((place for function in candidates for place in _uses(function, named[1])), None)


def raised_at(problem: BaseException, files: Iterable[Path]) -> Place | None:
    """Return the author's own innermost line that an exception passed through; None if there is none."""
    folders = list(files)
    frames = traceback.extract_tb(problem.__traceback__)
    places = [Place(file, f.lineno or 0) for f in frames if (file := _as_it_lies_now(f.filename, folders))]
    return places[-1] if places else None


@contextmanager
def faults_of(part: Any, described: str, method: str) -> Iterator[None]:
    """Turn whatever a method of a part raises into an error that names the part, and its author's line.

    Raises:
        StrategyError: with all of that, unless it is an error of acoexp's.
    """
    try:
        yield
    except (AcoexpError, KeyboardInterrupt):
        raise
    except BaseException as problem:  # sys.exit() too: a part does not end the program
        what = f"{type(problem).__name__}: {problem}"
        place = raised_at(problem, sources_of(part))
        raise StrategyError(f"{described} failed in {method}: {what}{at(place)}") from problem


def at(place: Place | None) -> str:
    """Return the end of a message that tells where; nothing if nobody knows."""
    return "" if place is None else f"; {place}"


def sources_of(part: Any) -> list[Path]:
    """Return where the author of a part keeps sources: the top-level package's folders, or single files."""
    kernel = getattr(part, "kernel", None)
    code = getattr(getattr(kernel, "py_func", kernel), "__code__", None)
    module = sys.modules.get(type(part).__module__.partition(".")[0])
    files = [*getattr(module, "__path__", []), getattr(module, "__file__", None) or ""]
    files.append("" if code is None else code.co_filename)
    return [Path(file) for file in files if file]


def compiled_functions(owner: type) -> list[Any]:
    """Return every compiled function in the modules of a part's top-level package."""
    package = owner.__module__.partition(".")[0]
    modules = [module for name, module in list(sys.modules.items()) if name.partition(".")[0] == package]
    values = (value for module in modules for value in list(vars(module).values()))
    return [value.py_func for value in values if hasattr(value, "py_func") and hasattr(value, "targetoptions")]


def _shortened(text: str) -> str:
    """Return an error's text without the way the compiler got there, and without what a colony consists of."""
    for types in ("Colony|Crowd|Own|Trails|Record", "Room"):  # a room's own parts first
        text = re.sub(rf"\b({types})\((?:[^()]|\([^()]*\))*\)", r"\1", text)
    lines = text.splitlines()
    skipped = ("Failed in nopython", "- Resolution failure")
    return "\n".join(line for line in lines if line.strip() and not line.strip().startswith(skipped))


def _is_in(file: str, folders: Iterable[Path]) -> bool:
    return any(Path(file) == folder or folder in Path(file).parents for folder in folders)


def _as_it_lies_now(file: str, folders: Iterable[Path]) -> str | None:
    """Return the path of a file in these folders, or None.

    Kept machine code names its sources by where they lay when it was compiled; a package may have moved since.
    """
    if _is_in(file, folders):
        return file
    for folder in folders:
        above, name, inside = file.rpartition(f"/{folder.name}/")
        if name and above and (folder / inside).is_file():
            return str(folder / inside)
    return None


def _uses(function: Any, name: str) -> Iterator[Place]:
    """Yield the lines at which a function uses a global or an attribute of this name."""
    line = function.__code__.co_firstlineno
    for instruction in dis.get_instructions(function):
        position = instruction.positions
        line = position.lineno if position is not None and position.lineno is not None else line
        if instruction.argval == name and instruction.opname.startswith(("LOAD_", "STORE_ATTR")):
            yield Place(function.__code__.co_filename, line)
