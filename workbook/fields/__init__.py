"""The kinds of entries: numbers within limits, names and texts, the units in which they are entered."""
