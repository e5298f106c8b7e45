"""What every description holds: phases, the machine, the check of a design, what Excel accepts in a cell."""
