"""Mechanisms between the gears and the load: the register of all, and those whose ratio or load changes on the way."""
