"""Trials in the formats of other programs."""
