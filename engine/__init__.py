"""The reference of the mechanics: motion laws, motions, timing diagrams, drives; SI units, angles in rad, NumPy."""
