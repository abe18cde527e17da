"""Reports: what is made of many trials; what one is, and the comparison of any two or more configurations."""
