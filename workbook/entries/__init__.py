"""What every description shares: types, units, the machine, what Excel accepts in a cell."""
