"""The parts of a book: sheet, quantity, chart, address, formula."""
