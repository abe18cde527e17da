"""Where the results of trials are kept, and found again."""
