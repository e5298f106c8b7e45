"""Cam tables: the motion that a controller rebuilds from a table, and its deviation from that meant."""
