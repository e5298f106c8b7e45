"""The sheet Selection of a machine: motors by reducers for the axis that is named on it."""
