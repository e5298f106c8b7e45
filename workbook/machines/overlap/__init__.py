"""Overlap of a transfer and its tools (S2)."""
