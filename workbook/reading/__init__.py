"""Reads a workbook from anywhere: guards against it, opens it, finds what was entered."""
