"""What a mechanism's page gives to the table of points, and to that of samples."""

from collections.abc import Callable
from typing import Any, Protocol

from engine.laws.base import Array
from workbook.book.declare import Quantity
from workbook.machines.machine.drive.driven import Driven

Column = Callable[[Array], list[float]]
"""makes a column of a table of an array of values at its places"""


class MechanismPage(Protocol):
    """What the sheet of a drive has of a mechanism; formulas in the scope of the drive."""

    def entries(self, driven: Driven, key: str) -> list[Quantity]:
        """Return the rows of what is entered."""

    def sizes(self, driven: Driven) -> list[Quantity]:
        """Return the rows of its sizes in m, and of where it can bring its load to."""


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

    WRONG: str
    """the formula of what is said where they do not"""
    ENDS: dict[str, str]
    """the formulas of the names of both ends of the reach, ``low`` and ``high``"""

    def varied(self, i: int, k: int, room: int) -> tuple[dict[str, Any], float, float]:
        """Return other entries for the i-th axis in the k-th variation, and two positions it then reaches (mm or °).

        ``room`` is how many points a table of positions has room for.
        """

    def ratios(self, driven: Driven, position: Array, of: Column) -> list[Quantity]:
        """Return the columns of φ' (``g``), φ'' (``h``) and the shaft's angle at the position in the column ``y``."""
