"""The pages of the laws: each :class:`Page` of a file, or of a list in it, is all that a workbook needs of a law."""
