"""Tuning: Optuna chooses what the jobs of a sweep are told, by what earlier ones returned."""
