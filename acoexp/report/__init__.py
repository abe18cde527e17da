"""What a report is, and what it is given; not one report is here."""
