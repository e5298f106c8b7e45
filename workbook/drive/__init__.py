"""Blocks of a drive that several machines use, named within its scope: a sheet places them in ``Sheet.scoped``."""
