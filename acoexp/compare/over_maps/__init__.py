"""What trials say over maps: maps are what inference is drawn from; seeds tell how well each is known."""
