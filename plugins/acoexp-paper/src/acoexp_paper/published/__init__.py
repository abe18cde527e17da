"""What the paper prints: its tables, and what in them cannot be."""
