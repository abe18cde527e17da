"""Tracking: where the results of trials go. A tracker is chosen by ``tracking.name``."""

from acoexp.tracking.setup import Setup, Trial
from acoexp.tracking.tracker import Found, NoTracker, Tracker, open_tracker

__all__ = ["Found", "NoTracker", "Setup", "Tracker", "Trial", "open_tracker"]
