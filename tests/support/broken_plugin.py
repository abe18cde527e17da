"""A package whose parts and presets are broken, each in its own way."""

from __future__ import annotations

from acoexp.registry.presets import find_preset

PARTS = '''
from dataclasses import dataclass
from typing import ClassVar

from acoexp.colony.compiled import compiled
from acoexp.parameters import parameter
from acoexp.strategies import Choice, Diffusion, Heuristic


@compiled
def look_into_nothing(colony, own, ant, cell, came):
    colony.nothing[cell] = 1.0


@compiled
def open_all(colony, own, ant, cell, came):
    for edge in range(cell * 8, cell * 8 + 8):
        colony.weight[edge] = 1.0


@compiled
def stay(colony, own, ant, cell, came):
    pass


@compiled
def give_up(colony, own, ant, cell, came):
    raise ValueError("given up")


@compiled
def go_east(colony, own, ant, cell, came):
    return 0


@dataclass(frozen=True, kw_only=True)
class Uncompilable(Diffusion):
    """Does not compile."""

    kernel = staticmethod(look_into_nothing)


@dataclass(frozen=True, kw_only=True)
class Unprepared(Diffusion):
    """Raises in prepare."""

    kernel = staticmethod(stay)

    def prepare(self, problem):
        raise ZeroDivisionError("too bad")


@dataclass(frozen=True, kw_only=True)
class Listing(Diffusion):
    """Prepares what no kernel can take."""

    kernel = staticmethod(stay)

    def prepare(self, problem):
        return (1.0, [2.0])


@dataclass(frozen=True, kw_only=True)
class Raising(Diffusion):
    """Raises at a step."""

    kernel = staticmethod(give_up)


@dataclass(frozen=True, kw_only=True)
class Newer(Diffusion):
    """Asks for what is yet to come."""

    contract: ClassVar[int] = 3
    kernel = staticmethod(stay)


def wander(colony, own, ant, cell, came):
    pass


@compiled
def hesitate(colony, own, cell):
    pass


@dataclass(frozen=True, kw_only=True)
class Plain(Diffusion):
    """Its kernel is plain Python."""

    kernel = staticmethod(wander)


@dataclass(frozen=True, kw_only=True)
class Misfit(Diffusion):
    """Its kernel takes something else."""

    kernel = staticmethod(hesitate)


@dataclass(frozen=True, kw_only=True)
class Method(Diffusion):
    """Its kernel would be bound to it."""

    kernel = stay


@dataclass(frozen=True, kw_only=True)
class Idle(Diffusion):
    """Has no kernel."""


@dataclass(frozen=True, kw_only=True)
class Undeclared(Diffusion):
    """Has a field that is no parameter."""

    share: float = 0.5
    kernel = staticmethod(stay)


@dataclass(frozen=True, kw_only=True)
class Manifold(Diffusion):
    """Has a parameter of a type that nothing checks."""

    shares: list[float] = parameter((), "shares")
    kernel = staticmethod(stay)


@dataclass(frozen=True, kw_only=True)
class Picky(Diffusion):
    """Refuses its own default."""

    share: float = parameter(0.5, "a share")
    kernel = staticmethod(stay)

    def __post_init__(self):
        raise ValueError("half is too much")


@dataclass(frozen=True, kw_only=True)
class Blind(Heuristic):
    """Leaves out eta."""


@dataclass(frozen=True, kw_only=True)
class Stray(Diffusion):
    """Writes to what is not its own, so that others fail."""

    kernel = staticmethod(open_all)


@dataclass(frozen=True, kw_only=True)
class Eastwards(Choice):
    """Goes through walls."""

    kernel = staticmethod(go_east)
'''
ENTRIES = """
[acoexp.diffusion]
uncompilable = bad_parts:Uncompilable
unprepared = bad_parts:Unprepared
listing = bad_parts:Listing
raising = bad_parts:Raising
newer = bad_parts:Newer
gaussian = bad_parts:Newer
absent = bad_parts:Absent
plain = bad_parts:Plain
misfit = bad_parts:Misfit
method = bad_parts:Method
idle = bad_parts:Idle
undeclared = bad_parts:Undeclared
manifold = bad_parts:Manifold
picky = bad_parts:Picky
stray = bad_parts:Stray

[acoexp.heuristic]
blind = bad_parts:Blind

[acoexp.difusion]
breeze = bad_parts:Newer

[acoexp.choice]
eastwards = bad_parts:Eastwards

[acoexp.presets]
bad = bad_parts
gone = no_such_package
odd = ..
"""
PRESETS = {
    "pdg": "algo: pdg\nrho: 0.9\n",
    "torn": "defaults: [\n",
    "empty": "",
    "misnamed": "defaults: []\nalgo: other\n",
    "partial": "defaults:\n  - override /post: none\nalgo: partial\n",
    "wrong": "defaults:\n"
    + "".join(f"  - override /{group}: {part}\n" for group, part in find_preset("pd").parts.items())
    + "algo: wrong\nants: many\n",
}
