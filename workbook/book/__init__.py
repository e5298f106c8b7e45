"""What a book is made of: sheet, quantity, chart, address, formula."""
