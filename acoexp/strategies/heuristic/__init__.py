"""Heuristics: how desirable a move is before the first ant walks."""
