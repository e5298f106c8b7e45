"""Any machine: its axes over one master shaft, at one rate."""
