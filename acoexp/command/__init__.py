"""The command line, and all that knows of Hydra: arguments, jobs, sweeps, what a person sees."""
