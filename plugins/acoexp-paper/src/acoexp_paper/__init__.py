"""What Liu et al. 2017 published, run again, and judged: ``report=paper`` of acoexp.

Data goes one way: ``published``, ``trials``, ``claims``, then ``figures`` and ``page``; ``report`` calls them.
"""
