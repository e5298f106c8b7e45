"""A motion in cells: its phases become a table of pieces, from which each sample has y, y', y'', y''' directly."""
