"""Trust: what an option file may say. It may come from anybody, so it sets values and reaches nothing else.

The command line itself is trusted: whoever types it may run what they like.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import PurePosixPath
from typing import Any

from hydra.errors import HydraException

_RUNS_CODE = re.compile(r"(^|[\s/@.])hydra(?!\w)|_target_")
_PLAIN_REFERENCE = re.compile(r"\$\{[\w.\[\]-]*\}")
_KEYWORDS = ("_global_", "_group_", "_here_", "_name_")
"""Words that Hydra replaces in a package. Within another word it cuts them out, and what is left counts."""
_PLACES = (("tracking", "uri"), ("tracking", "experiment"), ("report", "folder"))
"""Where results go, by the group and its key: only the command line says it."""


def check_option(file: str, config_path: str, package: str, content: Any) -> None:
    """Refuse an option file that reaches for more than acoexp's own settings.

    Args:
        file: What it is called in messages.
        config_path: Where it stands among the options, such as ``algo/mine``.
        package: Where its content goes, by its header; empty for its group.
        content: Its content, unresolved.

    Raises:
        HydraException: if it sets ``hydra.*`` or ``_target_``; takes options from outside the folders of options;
            reads the environment or files by a resolver; or says where results go.
    """
    group = config_path.rpartition("/")[0].replace("/", ".")
    places = [group, package, *(entry.partition("@")[2] for entry in _defaults(content))]
    for place in filter(None, places):
        if not all(map(_is_plain, place.split("."))):
            raise HydraException(
                f"{file}: expected a package of names and dots, such as _global_ or diffusion; got {place!r}"
            )
    if _RUNS_CODE.search(f"{config_path} {package}") or any(map(_RUNS_CODE.search, _named(content))):
        raise HydraException(
            f"{file}: expected settings of acoexp only; an option file may not set hydra.* or _target_, which run "
            "code"
        )
    for path in _defaults(content):
        if ".." in PurePosixPath(path).parts or path.startswith(("/", "~")) or "\\" in path:
            raise HydraException(
                f"{file}: expected names of options in its defaults; got {path!r}, which leads out of the folders"
            )
    for text in _texts(content):
        if "${" in _PLAIN_REFERENCE.sub("", text):
            raise HydraException(
                f"{file}: expected plain values, or references such as ${{ants}}; an option file may not read the "
                f"environment or files: got {text!r}"
            )
    for group, key in _PLACES:
        there = re.compile(rf"(^|[./@]){group}([./@].*)?$")
        elsewhere = any(there.search(entry.partition("@")[2]) for entry in _defaults(content))
        within = bool(there.search(package or config_path.rpartition("/")[0]))
        if elsewhere or _sets_place(content, group, key, within):
            raise HydraException(
                f"{file}: expected no {group}.{key}; where results go is said on the command line: "
                f"{group}.{key}=..."
            )


def _is_plain(word: str) -> bool:
    """Tell whether a part of a package is a name, or a whole keyword of Hydra's."""
    return word in _KEYWORDS or (
        re.fullmatch(r"[\w-]+", word) is not None and not any(k in word for k in _KEYWORDS)
    )


def _named(content: Any, in_defaults: bool = False) -> Iterator[str]:
    """Yield every key, and every text of a defaults list."""
    if isinstance(content, dict):
        for key, value in content.items():
            yield str(key)
            yield from _named(value, in_defaults or str(key) == "defaults")
    elif isinstance(content, list):
        for item in content:
            yield from _named(item, in_defaults)
    elif in_defaults:
        yield str(content)


def _defaults(content: Any) -> Iterator[str]:
    """Yield what a file's defaults list names: options, and for a group the options chosen from it."""
    entries = content.get("defaults", []) if isinstance(content, dict) else []
    for entry in entries if isinstance(entries, list) else []:
        if isinstance(entry, dict):
            for group, chosen in entry.items():
                yield str(group).rpartition(" ")[2].removeprefix("/")
                yield from map(str, chosen if isinstance(chosen, list) else [chosen])
        else:
            yield str(entry)


def _texts(content: Any) -> Iterator[str]:
    """Yield every text in a file's content, keys among them."""
    if isinstance(content, dict):
        for key, value in content.items():
            yield str(key)
            yield from _texts(value)
    elif isinstance(content, list):
        for item in content:
            yield from _texts(item)
    elif isinstance(content, str):
        yield content


def _sets_place(content: Any, group: str, key: str, within: bool) -> bool:
    """Tell whether a file sets a key within its group."""
    if not isinstance(content, dict):
        return False
    return any(
        (within and str(name) == key)
        or str(name) == f"{group}.{key}"
        or _sets_place(value, group, key, within or str(name) == group)
        for name, value in content.items()
    )
