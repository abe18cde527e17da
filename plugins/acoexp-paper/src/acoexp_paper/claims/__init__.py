"""What the paper says of its trials, and what ours say of that: averages, claims, verdicts."""
