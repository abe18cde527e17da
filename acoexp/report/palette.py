"""The colours of pictures: Okabe and Ito's, told apart by the colour-blind."""

BLUE, ORANGE, GREEN = "#0072B2", "#D55E00", "#009E73"

SERIES = (BLUE, ORANGE, GREEN, "#CC79A7", "#56B4E9", "#E69F00", "#000000")
"""Of lines side by side: all but yellow, which is faint on white."""

DASHES = ("-", "--", "-.", ":")
