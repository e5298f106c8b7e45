"""Blocks of a drive that several machines use: load, motor, what they are entered as."""
