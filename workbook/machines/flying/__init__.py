"""Flying machining (S5)."""
