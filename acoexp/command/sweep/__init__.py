"""A sweep: planned and checked before its jobs run; Hydra calls here."""
