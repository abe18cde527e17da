"""Tracking: where the results of trials go. A tracker is chosen by ``tracking.name``."""

from acoexp.tracking.tracker import NoTracker, Tracker, Trial, open_tracker

__all__ = ["NoTracker", "Tracker", "Trial", "open_tracker"]
