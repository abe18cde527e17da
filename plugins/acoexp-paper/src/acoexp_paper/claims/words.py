"""The words of the verdicts, and what each means."""

from __future__ import annotations

SHOWN, COMPATIBLE, CONTRADICTED = "shown", "compatible", "contradicted"
DEPENDS, UNDECIDED = "depends on the map", "undecided"

MEANING = {
    SHOWN: "a comparison comes out as published: its effect, pooled over the maps, lies on the paper's side "
    "(p < 0.05 after Holm's correction), and does not depend on the map",
    COMPATIBLE: "a printed number is one that ten of our trials may well give (p at least 0.05) on a map that is "
    "drawn from ours; that is no proof of it",
    CONTRADICTED: "a comparison is shown the other way round, or a printed number is one that ten of our trials "
    "would hardly give (p < 0.05)",
    DEPENDS: "the maps differ by more than their seeds do (p < 0.01), and what they differ in is the answer: the "
    "prediction interval of one more map lies on both sides, or between a tenth and nine tenths of the maps are "
    "compatible with the printed number",
    UNDECIDED: "a comparison of which none of this can be said: its effect is not told apart from none",
}
"""The definition of each verdict, in the order in which they are counted."""

VERDICTS = tuple(MEANING)
