"""Diffusions: what pheromone does while an ant stands on a cell."""
