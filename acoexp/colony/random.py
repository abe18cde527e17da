"""Random numbers: xoshiro256++ (Blackman and Vigna 2019), seeded through SplitMix64, one stream per trial.

Its state is four uint64 that the colony carries, so a trial's numbers depend on its seed and nothing else.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled

_U = np.uint64
_GOLDEN = _U(0x9E3779B97F4A7C15)
_MIX_1 = _U(0xBF58476D1CE4E5B9)
_MIX_2 = _U(0x94D049BB133111EB)
_S11, _S17, _S19, _S23, _S27, _S30, _S31, _S41, _S45 = map(_U, (11, 17, 19, 23, 27, 30, 31, 41, 45))
_TO_UNIT = 2.0**-53


@compiled
def seed_stream(state: Any, seed: Any) -> None:
    """Fill ``state`` (uint64[4]) from a seed (uint64), by four draws of SplitMix64."""
    counter = seed
    for i in range(4):
        counter = counter + _GOLDEN
        mixed = (counter ^ (counter >> _S30)) * _MIX_1
        mixed = (mixed ^ (mixed >> _S27)) * _MIX_2
        state[i] = mixed ^ (mixed >> _S31)


@compiled
def uniform(state: Any) -> Any:
    """Draw a float64 in [0, 1), a multiple of 2^-53, and advance ``state`` (uint64[4])."""
    s0, s1, s2, s3 = state[0], state[1], state[2], state[3]
    total = s0 + s3
    drawn = ((total << _S23) | (total >> _S41)) + s0
    s2 ^= s0
    s3 ^= s1
    state[0] = s0 ^ s3
    state[1] = s1 ^ s2
    state[2] = s2 ^ (s1 << _S17)
    state[3] = (s3 << _S45) | (s3 >> _S19)
    return (drawn >> _S11) * _TO_UNIT
