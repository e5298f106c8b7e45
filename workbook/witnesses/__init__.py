"""Witnesses: independent ways to say what each formula cell of a workbook computes."""
