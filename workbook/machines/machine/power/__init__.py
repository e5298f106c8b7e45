"""The power of all drives: the engine's view and the sheet Power."""
