"""Tells what was found: on the terminal, as a page, as JUnit XML."""
