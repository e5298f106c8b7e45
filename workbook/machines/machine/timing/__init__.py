"""The timing diagram: the sheets Timing and Cycle."""
