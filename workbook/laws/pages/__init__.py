"""A file for each family of laws, named as in the registry, whose ``PAGE`` is all that a workbook needs of it."""
