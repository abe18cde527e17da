"""What the loop returns of a trial that came to no good end; it is 0 if it did, and else a cycle."""

from __future__ import annotations

NO_PATH = -1
"""What the loop returns if a choice made moves that are not allowed."""

UNSOUND = -3
"""What the loop returns if a part made pheromone negative or not a number."""

STOPPED = -2
"""What the loop returns if it was told to stop."""
