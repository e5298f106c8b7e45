"""Tells the findings: on the terminal, as a page, as JUnit XML."""
