"""Hydra's own doors for acoexp: the sweeper of its sweeps."""
