"""Two books or descriptions compared: entries, results, checks, formulas and cells of one's own."""
