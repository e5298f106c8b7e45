"""The pages of the laws: each :class:`Page` of a file is one, and all that a workbook needs of a law."""
