"""What is run: the paper's algorithms on its environments' maps, by the defaults and by other readings of it."""
