"""The display of a book: whether it tells the number, the quantity and the verdict that its cells have."""
