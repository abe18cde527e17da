"""The colony: its state, its random numbers, its pheromone, and the loop that runs it."""
