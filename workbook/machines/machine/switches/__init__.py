"""Switches over the cycle: entries, the engine's view, the sheet Switches."""
