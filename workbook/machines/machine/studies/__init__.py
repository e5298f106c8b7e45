"""Results of many designs of a machine at once, without a book."""
