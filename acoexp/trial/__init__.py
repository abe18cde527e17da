"""All that a result depends on: settings, seed, preparation, solver, result, failures, tables."""
