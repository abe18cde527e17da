"""The colony: the compiled kernels around one loop, and what they carry."""
