"""The mechanism on the sheet of a drive: a page where its ratio changes, lists of rows else."""

from collections.abc import Callable
from typing import Any, NamedTuple

from engine.laws.base import Array
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.entries.facts import entry_cells
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.mechanism import MechanismEntry

CELLS = cell_tables(__file__)

# makes a column of a table of an array of values at its places
Column = Callable[[Array], list[float]]
# declares a table of as many rows as the book has for positions
Table = Callable[[Sheet, Driven, int], None]


class LinkagePage(NamedTuple):
    """The part of a sheet for a mechanism whose ratio depends on the position; formulas in the scope of the drive."""

    # the rows of its sizes in m, and of where it can bring its load to
    sizes: Callable[[Driven], list[Quantity]]
    ratios: Callable[[Driven, Array, Column], list[Quantity]]
    """the columns of φ' (``g``), φ'' (``h``) and the shaft's angle at the position in the column ``y``"""
    varied: Callable[[int, int, int], tuple[dict[str, Any], float, float]]
    """of the number of an axis, of a variation and of the rows for positions: other entries, and two positions that the
    mechanism then reaches (mm or °)"""
    sized: str  # the condition under which its sizes are entered
    fits: str  # the condition under which they go together
    holds: str  # what that is about
    wrong: str  # the formula of what is said where they do not
    within: str  # between what it reaches its positions
    # the formulas of the names of both ends of the reach, ``low`` and ``high``
    ends: dict[str, str]
    entered: Table | None = None  # the table of what is entered, if it has one
    worked: Table | None = None  # that of its workings


RATIOS = {
    "lead": ("2*PI()/(@lead/1000)", "2π/P_h"),
    "roller_radius": ("1/(@roller_radius/1000)", "1/R"),
    "": ("1", "the load turns with it"),
}
"""of the entry that sets a constant ratio: the ratio in cells and in words; of all others 2/D"""


def entered_sizes(driven: Driven, key: str) -> list[Quantity]:
    """Return the rows of what is entered of a mechanism's own sizes, that of a constant ratio first."""
    m, unasked = driven.given, () if driven.has_bed else ("belt_on_bed",)
    rows = entry_cells(m, f"{key}.mechanism", {*MechanismEntry.model_fields, *unasked})
    return sorted(rows, key=lambda row: row.name != f"@{m.SIZE}")


def constant_sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of the ratios."""
    cell, m = CELLS["constant_sizes"], driven.mechanism
    unit = "rad/m" if driven.axis.base == "m" else ""
    size = driven.given.SIZE
    ratio, equation = RATIOS.get(size, (f"2/(@{size}/1000)", "2/D"))
    stages, stages_symbol = ("*@is", "i_s ") if driven.entered.stages else ("", "")
    return [
        cell("@i2", m.ratio_from(m.last - 1), unit=unit, ratio=ratio, equation=equation),
        cell("@i", m.ratio, unit=unit, stages=stages, stages_symbol=stages_symbol),
    ]
