"""How SQLite databases are opened by us, beside MLflow."""

from __future__ import annotations

BUSY = 10.0
"""Seconds for which a database may be locked by another program before it is made ready."""
