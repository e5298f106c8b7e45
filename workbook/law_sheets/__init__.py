"""The laws of a book as its sheets have them: a page each, the sheet Laws, other parameters for variations."""
