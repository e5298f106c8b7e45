"""A motion in cells: its phases become one table of pieces, from which each sample has y, y', y'', y''' directly."""
