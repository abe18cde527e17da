"""What an option file may say: it may come from anybody, so it sets values and reaches nothing else."""

from __future__ import annotations

import re
from typing import Any

import pytest
from hydra.errors import HydraException
from omegaconf import OmegaConf

from acoexp.command.options.trust import check_option

HARMLESS = "rho: 0.25\ndiffusion:\n  gamma: 0.5\n"


def check(content: str, path: str = "study/mine", package: str = "") -> None:
    """Check an option file as it is checked when it is read."""
    plain: Any = OmegaConf.to_container(OmegaConf.create(content), resolve=False)
    check_option("mine.yaml", path, package, plain)


def refusal(content: str, path: str = "study/mine", package: str = "") -> str:
    """Return the message with which an option file is refused."""
    with pytest.raises(HydraException, match=r"^mine\.yaml: expected ") as caught:
        check(content, path, package)
    return str(caught.value).removeprefix("mine.yaml: expected ")


@pytest.mark.parametrize("path", ["algo/own", "study/own", "hydraulics/own", "study/hydra_free"])
@pytest.mark.parametrize("package", ["", "_global_", "diffusion", "hydraulics"])
def test_settings_of_ours_are_welcome_wherever_they_stand(path: str, package: str) -> None:
    check(HARMLESS, path, package)


@pytest.mark.parametrize(
    "content",
    [
        "defaults:\n  - override /diffusion: none\n  - mine\n  - _self_\nants: 3\n",
        "defaults:\n  - /study: slow\n  - optional wide@field: null\n",
        "rho: ${q}\ntau0: ${field.reach}\nmap:\n  start: [1, 2]\n",
        "map:\n  path: hydra.txt\n",
        "map:\n  path: ../maps/yard.txt\n",
        "report:\n  cells: [aco, pd ants=3]\n",
        "",
    ],
)
def test_options_and_references_and_any_value_are_welcome(content: str) -> None:
    check(content, package="_global_")


@pytest.mark.parametrize(
    "package",
    [
        "_global_xhydra",
        "[hydra]",
        "x_global_",
        "_global_.[tracking]",
        "hydra_global_x",
        "_global_xtracking",
    ],
)
def test_a_package_that_hydra_would_read_in_another_way_is_refused(package: str) -> None:
    for given in (
        refusal(HARMLESS, package=package),
        refusal(f"defaults:\n  - /study@{package}: slow\n"),
        refusal(HARMLESS, path=f"{package}/mine"),
    ):
        assert given.startswith("a package of names and dots, such as _global_ or diffusion; got ")


@pytest.mark.parametrize(
    "content",
    [
        "hydra:\n  run:\n    dir: x\n",
        "hydra.run.dir: x\n",
        "_target_: os.getcwd\n",
        "diffusion:\n  _target_: os.getcwd\n",
        "diffusion:\n  - [{a: {_target_: os.getcwd}}]\n",
        "defaults:\n  - override /hydra/launcher: joblib\n",
        "defaults:\n  - /hydra/launcher: joblib\n",
        "defaults:\n  - hydra/launcher: joblib\n",
        "defaults:\n  - /hydra/launcher/joblib\n",
        "defaults:\n  - /hydra/launcher/joblib@diffusion\n",
        "defaults:\n  - other@hydra.callbacks.evil: x\n",
        "defaults:\n  - other@_global_.hydra.callbacks.evil: x\n",
        "defaults:\n  - optional other@hydra.callbacks: x\n",
        "defaults:\n  - /other/x@hydra.callbacks.evil\n",
        "defaults:\n  - /other/x@_global_.hydra.callbacks.evil\n",
        "defaults:\n  - override /other@hydra.callbacks: [x, y]\n",
    ],
)
def test_content_that_reaches_for_hydra_or_for_code_is_refused(content: str) -> None:
    assert refusal(content).startswith("settings of acoexp only; an option file may not set hydra.* or _target_")


@pytest.mark.parametrize("package", ["hydra", "hydra.callbacks.evil", "_global_.hydra.callbacks.evil"])
def test_a_package_of_hydras_is_refused(package: str) -> None:
    assert refusal(HARMLESS, package=package).startswith("settings of acoexp only")


@pytest.mark.parametrize("path", ["hydra/callbacks/evil", "hydra/evil", "study/hydra/evil"])
def test_a_file_under_a_folder_called_hydra_is_refused(path: str) -> None:
    assert refusal(HARMLESS, path).startswith("settings of acoexp only")


@pytest.mark.parametrize(
    ("entry", "path"),
    [
        ("../secret", "../secret"),
        ("/study: ../../secret", "../../secret"),
        ("study/../../secret: x", "study/../../secret"),
        ("~/secret", "~/secret"),
        ("//etc/secret: x", "/etc/secret"),
        ("/study: /etc/secret", "/etc/secret"),
        ("/study: [slow, ../secret]", "../secret"),
        (r"..\secret", r"..\secret"),
    ],
)
def test_defaults_that_lead_out_of_the_folders_are_refused(entry: str, path: str) -> None:
    said = refusal(f"defaults:\n  - {entry}\n")
    assert said == f"names of options in its defaults; got {path!r}, which leads out of the folders"


@pytest.mark.parametrize(
    "text",
    ["${oc.env:HOME}", "${hydra:runtime.cwd}", "a${oc.env:HOME}b", "${ants}${oc.env:HOME}", "${a${oc.env:HOME}}"],
)
def test_a_resolver_could_read_the_environment_and_is_refused_as_value_and_as_key(text: str) -> None:
    for content in ({"map": {"path": text}}, {"maps": [text]}, {text: 1}):
        with pytest.raises(HydraException, match="may not read the environment or files: got "):
            check_option("mine.yaml", "study/mine", "", content)


@pytest.mark.parametrize(
    ("content", "path", "package"),
    [
        ("tracking:\n  uri: x\n", "study/mine", "_global_"),
        ("tracking.uri: x\n", "study/mine", "_global_"),
        ("uri: x\n", "study/mine", "tracking"),
        ("uri: x\n", "study/mine", "_global_.tracking"),
        ("uri: x\n", "tracking/mine", ""),
        ("defaults:\n  - /other@tracking: address\n", "study/mine", "_global_"),
        ("report:\n  folder: x\n", "study/mine", "_global_"),
        ("report.folder: x\n", "study/mine", "_global_"),
        ("folder: x\n", "report/mine", ""),
        ("defaults:\n  - address@_global_.tracking\n", "study/mine", "_global_"),
    ],
)
def test_where_results_go_is_for_the_command_line_to_say(content: str, path: str, package: str) -> None:
    said = "no (tracking.uri|report.folder); where results go is said on the command line: "
    assert re.match(said, refusal(content, path, package))


def test_whether_results_are_tracked_an_option_may_say() -> None:
    check("defaults:\n  - override /tracking: none\n", package="_global_")
    check("name: none\n", package="tracking")
