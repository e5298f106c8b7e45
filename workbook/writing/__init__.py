"""Writes a workbook: cells, styles, charts, the archive."""
