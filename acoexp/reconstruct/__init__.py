"""The search for the lost maps of Liu et al. 2017, under standard ACO alone."""
