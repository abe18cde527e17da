"""The report ``sensitivity``: which of a configuration's numbers matter on a map, and how much."""
