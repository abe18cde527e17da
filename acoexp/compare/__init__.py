"""The report ``compare``: any two or more configurations on any maps, side by side."""
