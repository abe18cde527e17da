"""Settings: everything about a trial but its map and its seed, as a person meets it again."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.metadata import version

from acoexp.parameters import parameter
from acoexp.registry.resolve import resolve
from acoexp.strategies import Diffusion
from acoexp.strategies.diffusion.gaussian import Gaussian
from acoexp.strategies.diffusion.none import NoDiffusion

ACOEXP = f"acoexp {version('acoexp')}"


@dataclass(frozen=True, kw_only=True)
class HomeMade(Diffusion):
    """A part made in a notebook, of no package."""

    share: float = parameter(0.5, "how much")

    kernel = staticmethod(NoDiffusion.kernel)


def test_they_are_nested_as_on_the_command_line_with_every_default() -> None:
    values = resolve("pd", {"rho": 0.25, "field": {"reach": 3}, "diffusion": {"gamma": 0.5}}).as_dict()
    assert (values["algo"], values["rho"], values["ants"]) == ("pd", 0.25, 10)
    assert values["diffusion"] == {"name": "gaussian", "gamma": 0.5, "source": "force_edge"}
    assert (values["field"]["reach"], values["field"]["attraction"]) == (3.0, 1.0)
    assert values["post"] == {"name": "none"}


def test_what_they_say_resolves_to_themselves() -> None:
    settings = resolve("pf", {"ants": 7, "heuristic": {"guidance": 0.3}})
    values = settings.as_dict()
    assert resolve(values.pop("algo"), values) == settings


def test_a_part_made_on_the_spot_is_called_like_its_class_with_its_parameters() -> None:
    values = resolve("aco", {"diffusion": HomeMade(share=0.25)}).as_dict()
    assert values["algo"] == "custom"
    assert values["diffusion"] == {"name": "HomeMade", "share": 0.25}


def test_a_part_is_described_with_the_package_that_registers_it() -> None:
    assert resolve("pd", {}).describe("diffusion") == f"diffusion 'gaussian' of package {ACOEXP}"
    assert resolve("pd", {"diffusion": HomeMade()}).describe("diffusion") == "diffusion 'HomeMade'"


def test_parts_of_no_package_are_in_no_list_of_packages() -> None:
    packages = resolve("aco", {"diffusion": HomeMade()}).packages
    assert packages == dict.fromkeys(("heuristic", "choice", "post", "update"), ACOEXP)


def test_parts_stand_under_their_groups() -> None:
    assert resolve("pd", {"diffusion": {"gamma": 0.5}}).parts["diffusion"] == Gaussian(gamma=0.5)
