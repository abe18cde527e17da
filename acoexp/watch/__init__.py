"""Seeing ants find the way: recordings of trials, and the page that plays them."""
