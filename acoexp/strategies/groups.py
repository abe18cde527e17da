"""The groups of strategies: one for each part of a colony."""

STRATEGY_GROUPS = ("heuristic", "choice", "diffusion", "post", "update")
"""In the order in which an ant meets them."""
