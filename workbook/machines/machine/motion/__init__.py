"""The motions of a machine's axes in its book."""
