"""Axes that must stay apart: entries, their gap over the cycle, the sheet Clearances."""
