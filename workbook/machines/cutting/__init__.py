"""The cutting machine of S1."""
