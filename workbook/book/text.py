"""A label on a sheet, and where it leads."""

from typing import NamedTuple


class Text(NamedTuple):
    """A label on the sheet, with the style it takes; ``link`` names a sheet to jump to, at a cell of it.

    Without a text it links the declared cell in its place.
    """

    row: int
    column: int
    text: str
    style: str
    link: str = ""
    linked_cell: str = "A1"
