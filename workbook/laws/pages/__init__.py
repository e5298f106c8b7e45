"""The pages of the laws, in files named as those of the engine: ``PAGES`` is all that a workbook needs of a file."""
