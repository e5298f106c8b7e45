"""The sheet Backlash: whether the torque of a drive changes sides while the tool works: its load crosses a gap."""

from collections.abc import Iterable, Sequence

import numpy as np

from engine.drive.backlash import Backlash
from engine.drive.motor import LimitCheck
from engine.laws.base import Array
from engine.timing import FULL_TURN
from workbook.book.cell_tables import cell_tables
from workbook.book.checks import ZERO
from workbook.book.declare import Book, Sheet
from workbook.book.rows import filled
from workbook.book.sentence import amount
from workbook.entries.facts import entry_cells
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine import drive_entries
from workbook.machines.machine.drive.view import DriveView
from workbook.template_outputs import JudgedLimit

CELLS = cell_tables(__file__)
ABOUT = "Where the torque changes sides, the load crosses the gap: motionbook improve lists when, and how it strikes."


class Sides:
    """The torques behind a reducer, backward and forward, in each interval of the cycle while the tool works (Nm)."""

    def __init__(self, view: DriveView, entered: drive_entries.Backlash) -> None:
        self.view, self.entered, driven = view, entered, view.driven
        self.window = driven.windows[entered.works - 1] if entered.works else None
        late = si(driven.axis.given.shift, DEGREE)
        middles = [interval.middle + late for interval in view.cycle.intervals]
        self.acts = np.array([float(bool(self.window and self.window.acts_at(x, FULL_TURN))) for x in middles])

    @property
    def by_interval(self) -> tuple[Array, Array]:
        """The greatest torques backward and forward at the points of each interval."""
        torques = self.view.load.output_torque * self.acts[:, None]
        return np.maximum(0.0, -torques).max(axis=1), np.maximum(0.0, torques).max(axis=1)

    @property
    def both(self) -> tuple[float, float]:
        """The greatest torques backward and forward at points."""
        back, fore = self.by_interval
        return float(back.max()), float(fore.max())

    @property
    def limit(self) -> JudgedLimit:
        """The torque on the other side as its sheet and as the exact engine have it: 0 but for rounding."""
        what, driven = "torque on the other side", self.view.driven
        exact = Backlash(driven.drive_cycle, 1.0).sides(self.window) if self.window else (0.0, 0.0)
        sheet, truth = (LimitCheck(what, min(each), ZERO * max(each)) for each in (self.both, exact))
        return JudgedLimit(f"back{driven.number}_sides", driven.called, what, "Nm", sheet, truth, 0.0)


def sides_of(views: Iterable[DriveView]) -> list[Sides]:
    """Return the torques of those drives that have a backlash."""
    return [Sides(view, entered) for view in views if (entered := view.driven.entered.backlash)]


def backlash_sheet(book: Book, sides: Sequence[Sides]) -> None:
    """Declare the sheet, where there is a backlash."""
    if not sides:
        return
    sheet = book.sheet("Backlash", "Whether loads cross their backlash while the tool works.")
    for side in sides:
        driven, (back, fore) = side.view.driven, side.both
        with sheet.scoped(f"back{driven.number}_"):
            sheet.heading(driven.called, ABOUT)
            place, unit = f"axes.{driven.number - 1}.backlash", driven.entered.unit
            sheet.rows(*entry_cells(side.entered, place, unit=unit))
            cell = CELLS["results"].sharing(called=driven.called, size=side.view.scales.behind)
            sheet.rows(cell("@back", back), cell("@fore", fore))
            says = amount("@back", back, "", " Nm backward, ").then(amount("@fore", fore, "", " Nm forward"))
            sheet.checks(cell("@sides", side.limit.sheet.ok, says=says))
    sheet.not_printed_below()
    for side in sides:
        workings(sheet, side)


def workings(sheet: Sheet, side: Sides) -> None:
    """Declare when the tool works, and the torques in each interval of the drive."""
    view, window, i = side.view, side.window, side.view.driven.number
    begin, end = (shown(window.begin, DEGREE), shown(window.end, DEGREE)) if window else (0.0, 0.0)
    with sheet.scoped(f"back{i}_"):
        sheet.heading(f"Workings: axis {i}")
        cell = CELLS["workings"].sharing(i=i)
        sheet.rows(cell("@from", begin), cell("@span", end - begin + TURN * (end < begin)))
        cell = CELLS["parts"].sharing(i=i, size=view.scales.behind)
        columns = zip(("works", "back", "fore"), (side.acts, *side.by_interval), strict=True)
        cell.place(sheet, *(cell(name, filled(values, view.rows)) for name, values in columns))
