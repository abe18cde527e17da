"""Who offers which part, preset and map, and from a name to the thing."""
