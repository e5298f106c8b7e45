"""The parts of every description: phases, the machine, the check of a design, Excel's limits of a cell."""
