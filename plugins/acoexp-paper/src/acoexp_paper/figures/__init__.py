"""The figures of the report, one file a kind; each is drawn from samples or single trials and never runs a batch."""
