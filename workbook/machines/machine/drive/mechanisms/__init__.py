"""What the sheet of a drive has of each kind of mechanism: entries, sizes, and its ratio at a position."""
