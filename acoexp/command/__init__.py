"""The command line: arguments, jobs, sweeps, and what a person sees of them; all that knows of Hydra."""
