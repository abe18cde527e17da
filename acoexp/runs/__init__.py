"""The only place where solving meets keeping: a trial, and a batch."""
