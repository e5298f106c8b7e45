"""Motion laws in the workbook: entries, pages, the stack of pieces, sampling, variations."""
