"""What Liu et al. 2017 published, run again, and judged: ``report=paper`` of acoexp."""
