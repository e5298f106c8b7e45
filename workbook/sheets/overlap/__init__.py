"""The sheets of two motions that overlap."""
