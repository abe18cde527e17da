"""The strategies: one short file each, registered by entry point like anybody's."""

from acoexp.strategies.part import Choice, Diffusion, Heuristic, Part, Post, Update

__all__ = ["Choice", "Diffusion", "Heuristic", "Part", "Post", "Update"]
