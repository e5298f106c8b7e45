"""Judges a workbook: its cells matched with their declarations, computed, compared."""
