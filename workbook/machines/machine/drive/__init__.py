"""The sheet of a drive: entries, results, and one table of its torque and speed at points of the cycle."""
