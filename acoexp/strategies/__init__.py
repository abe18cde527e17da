"""One strategy a file, registered by entry point like anybody's; ``part`` is the contract."""

from acoexp.strategies.part import Choice, Diffusion, Heuristic, Part, Post, Update

__all__ = ["Choice", "Diffusion", "Heuristic", "Part", "Post", "Update"]
