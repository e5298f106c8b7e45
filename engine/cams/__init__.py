"""Cam tables: a motion rebuilt from what a controller is given, and how far it is from the one that was meant."""
