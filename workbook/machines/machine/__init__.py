"""Any machine: its axes over a master shaft, at a single rate."""
