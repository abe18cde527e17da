"""The figures of the report, one file a kind, drawn from samples or from single trials."""
