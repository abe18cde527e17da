"""Where Hydra reads options from: folders that are checked, and asked for each thing once."""

from __future__ import annotations

from copy import deepcopy
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from hydra._internal.core_plugins.file_config_source import FileConfigSource
from hydra._internal.core_plugins.importlib_resources_config_source import ImportlibResourcesConfigSource
from hydra.core.object_type import ObjectType
from hydra.errors import HydraException
from hydra.plugins.config_source import ConfigLoadError

from acoexp.command.options import sources
from acoexp.command.options.sources import Remembered, UserOptions, remember_options
from acoexp.errors import SettingsError

HARMLESS = "rho: 0.25\ndiffusion:\n  gamma: 0.5\n"


def write(folder: Path, name: str, content: str) -> Path:
    """Write an option file."""
    file = folder / f"{name}.yaml"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(content, encoding="utf-8")
    return file


def options(folder: Path) -> UserOptions:
    """Return a folder of options as Hydra has it."""
    return UserOptions("test", f"options://{folder}")


# --- a user's folder


def test_settings_of_ours_are_read_with_their_header(tmp_path: Path) -> None:
    write(tmp_path, "study/own", f"# @package _global_\n{HARMLESS}")
    result = options(tmp_path).load_config("study/own")
    assert result.config == {"rho": 0.25, "diffusion": {"gamma": 0.5}}
    assert result.header == {"package": "_global_"}


def test_a_link_out_of_the_folder_is_not_followed(tmp_path: Path) -> None:
    secret = write(tmp_path / "elsewhere", "secret", "a: b: SECRET")
    folder = tmp_path / "options"
    (folder / "study").mkdir(parents=True)
    (folder / "study" / "linked.yaml").symlink_to(secret)
    (folder / "outside").symlink_to(secret.parent)
    for name in ("study/linked", "outside/secret"):
        with pytest.raises(HydraException, match="got a link that leads out of it") as caught:
            options(folder).load_config(name)
        assert "SECRET" not in str(caught.value)


@pytest.mark.parametrize(
    "content",
    [
        "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n"
        + "".join(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]\n" for n in range(1, 9)),
        "x: &x [*x]\n",
        "x: &x {a: *x}\n",
        "x: " + "[" * 3000 + "]" * 3000 + "\n",
        "x: 1\n" * 50_001,
        "# @package a b\nx: 1\n",
        "# @package\nx: 1\n",
    ],
    ids=["ten to the nine", "itself", "itself in a mapping", "deep", "large", "two packages", "no package"],
)
def test_a_file_that_is_endless_or_no_option_is_refused_in_one_line(content: str, tmp_path: Path) -> None:
    file = write(tmp_path, "study/evil", content)
    with pytest.raises(HydraException, match=f"^{file}: expected ") as caught:
        options(tmp_path).load_config("study/evil")
    assert len(str(caught.value)) < 1000
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("study/evil", "diffusion:\n  _target_: os.getcwd\n"),
        ("study/evil", "# @package hydra\njob:\n  name: x\n"),
        ("study/evil", "# @package  hydra.launcher\nrho: 1\n"),
        ("study/evil", "# @package _global_.hydra.callbacks.evil\nrho: 1\n"),
        ("hydra/evil", HARMLESS),
    ],
)
def test_a_file_that_reaches_for_more_is_refused_by_its_name(name: str, content: str, tmp_path: Path) -> None:
    file = write(tmp_path, name, content)
    with pytest.raises(HydraException) as caught:
        options(tmp_path).load_config(name)
    assert str(caught.value).startswith(f"{file}: expected settings of acoexp only")


@pytest.mark.parametrize("content", [b"rho: [\n", b"\xff\xfe", b"rho: 1\n  ants: 2\n"])
def test_a_file_that_is_no_yaml_is_named(content: bytes, tmp_path: Path) -> None:
    file = write(tmp_path, "study/torn", "")
    file.write_bytes(content)
    with pytest.raises(HydraException, match=r"expected YAML; ") as caught:
        options(tmp_path).load_config("study/torn")
    assert str(caught.value).startswith(str(file))
    assert "\n" not in str(caught.value)


def test_a_file_that_is_not_there_is_looked_for_elsewhere(tmp_path: Path) -> None:
    with pytest.raises(ConfigLoadError):
        options(tmp_path).load_config("study/nowhere")


@pytest.mark.parametrize("name", ["config", "settings"])
def test_the_programs_own_configuration_cannot_be_replaced_from_the_folder(name: str, tmp_path: Path) -> None:
    """Else a harmless-looking file would switch off the checks that a session makes before it runs."""
    file = write(tmp_path, name, "seed: 3\nalgo: aco\n")
    with pytest.raises(HydraException) as caught:
        options(tmp_path).load_config(name)
    assert str(caught.value).startswith(f"{file}: expected options in folders, such as algo/{name}")


def test_a_packages_preset_is_refused_as_it_is_in_python(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, "algo/nope", HARMLESS)
    assert options(tmp_path).load_config("algo/nope").config == {"rho": 0.25, "diffusion": {"gamma": 0.5}}
    monkeypatch.setattr(sources, "plugin_conf_dirs", lambda: {tmp_path: "windy 1.0"})
    with pytest.raises(SettingsError, match=r"^algo: expected one of: .*; got 'nope'"):
        options(tmp_path).load_config("algo/nope")


def test_groups_and_options_are_what_there_are_folders_and_files_of(tmp_path: Path) -> None:
    for name in ("study/wide", "study/deep/er", "study/slow"):
        write(tmp_path, name, HARMLESS)
    (tmp_path / "study" / "notes.txt").touch()
    folder = options(tmp_path)
    assert folder.list("study", ObjectType.CONFIG) == ["slow", "wide"]
    assert folder.list("study", ObjectType.GROUP) == ["deep"]
    assert (folder.is_group("study"), folder.is_group("study/slow"), folder.is_group("nope")) == (
        True,
        False,
        False,
    )
    assert (folder.is_config("study/slow"), folder.is_config("study")) == (True, False)
    assert (folder.available(), options(tmp_path / "nowhere").available()) == (True, False)


# --- what workers remember


def everything(folder: Any) -> list[Any]:
    """Ask a folder for all that there is."""
    return [
        folder.available(),
        folder.is_group("study"),
        folder.is_config("study/slow"),
        folder.is_config("study/nope"),
        folder.list("study", None),
        folder.load_config("study/slow").config,
    ]


def test_for_what_was_asked_nobody_needs_the_folder_any_more(tmp_path: Path) -> None:
    file = write(tmp_path, "study/slow", HARMLESS)
    remembered = Remembered(options(tmp_path))
    before = everything(remembered)
    file.unlink()
    file.parent.rmdir()
    assert everything(remembered) == before == [True, True, True, False, ["slow"], {**before[-1]}]


def test_a_copy_remembers_what_the_original_learns(tmp_path: Path) -> None:
    """Hydra composes each job from a copy of its sources."""
    file = write(tmp_path, "study/slow", HARMLESS)
    remembered = Remembered(options(tmp_path))
    copy = deepcopy(remembered)
    copy.load_config("study/slow")
    file.unlink()
    assert remembered.load_config("study/slow").config == {"rho": 0.25, "diffusion": {"gamma": 0.5}}


def test_who_changes_an_answer_changes_it_for_nobody_else(tmp_path: Path) -> None:
    write(tmp_path, "study/slow", HARMLESS)
    remembered = Remembered(options(tmp_path))
    remembered.load_config("study/slow").config.rho = 0.9
    remembered.list("study", None).append("mine")
    assert remembered.load_config("study/slow").config.rho == 0.25
    assert remembered.list("study", None) == ["slow"]


def test_what_was_refused_is_refused_again(tmp_path: Path) -> None:
    write(tmp_path, "study/torn", "rho: [\n")
    remembered = Remembered(options(tmp_path))
    for _ in range(2):
        with pytest.raises(HydraException, match="expected YAML"):
            remembered.load_config("study/torn")


def test_a_loader_remembers_what_it_reads_from_folders_and_nothing_else(tmp_path: Path) -> None:
    sources: list[Any] = [
        FileConfigSource("main", f"file://{tmp_path}"),
        ImportlibResourcesConfigSource("hydra", "pkg://hydra.conf"),
        options(tmp_path),
    ]
    loader: Any = SimpleNamespace(get_sources=lambda: sources)
    remember_options(loader)
    assert [type(source) for source in sources] == [
        Remembered, ImportlibResourcesConfigSource, Remembered,
    ]  # fmt: skip
    assert [source.provider for source in sources] == ["main", "hydra", "test"]
