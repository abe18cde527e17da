"""How compiled kernels are kept, once for a machine, and what code is told by."""
