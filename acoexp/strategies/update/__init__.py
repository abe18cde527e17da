"""Updates: what happens to the pheromone at the end of a cycle."""
