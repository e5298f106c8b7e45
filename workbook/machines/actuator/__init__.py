"""Sizing of an actuator (S4)."""
