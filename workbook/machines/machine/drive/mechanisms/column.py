"""What a mechanism's page gives to the table of points, and to that of samples."""

from collections.abc import Callable
from typing import Protocol

from engine.laws.base import Array
from workbook.book.declare import Quantity, Sheet
from workbook.machines.machine.drive.driven import Driven

Column = Callable[[Array], list[float]]
"""makes a column of a table of an array of values at its places"""


class MechanismPage(Protocol):
    """What the sheet of a drive has of a mechanism; formulas in the scope of the drive."""

    def entries(self, driven: Driven, key: str) -> list[Quantity]:
        """Return the rows of what is entered."""

    def entered(self, sheet: Sheet, driven: Driven, rows: int) -> None:
        """Declare the tables of what is entered, if any."""

    def sizes(self, driven: Driven) -> list[Quantity]:
        """Return the rows of its sizes in m, and of where it can bring its load to."""

    def table(self, sheet: Sheet, driven: Driven, rows: int) -> None:
        """Declare tables of workings, if any."""


class LinkagePage(MechanismPage, Protocol):
    """The same of a mechanism whose ratio depends on the position."""

    SIZED: str
    """the condition under which its sizes are entered"""
    FITS: str
    """the condition under which they go together"""
    HOLDS: str
    """what that is about"""
    WITHIN: str
    """between what it reaches its positions"""

    def wrong(self, driven: Driven) -> str:
        """Return the formula of what is said of sizes that do not go together."""

    def end(self, which: str) -> str:
        """Return the formula of the name of an end of the reach, ``low`` or ``high``."""

    def ratios(self, driven: Driven, position: Array, of: Column) -> list[Quantity]:
        """Return the columns of φ' (``g``) and φ'' (``h``) at the position in the column ``y``."""

    def angle(self, driven: Driven, position: Array, of: Column) -> Quantity:
        """Return the column of the shaft's angle, behind those of :meth:`ratios`."""
