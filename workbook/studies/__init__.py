"""Studies: many designs of a machine: the entries that vary, the results to keep, the best designs."""
