"""Post-optimisers: how an ant's path is made better."""
