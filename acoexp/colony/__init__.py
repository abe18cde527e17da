"""The colony: the compiled kernels around one loop, what they carry, and how they are kept."""
