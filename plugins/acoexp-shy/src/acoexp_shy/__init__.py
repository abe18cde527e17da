"""A pheromone diffusion for acoexp: each edge is weakened as it is walked."""
