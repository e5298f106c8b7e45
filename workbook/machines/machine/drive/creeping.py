"""A drive that creeps at 1 cycle/min, as a machine starts up: its torques against their limits, in cells."""

import math

from engine.drive.creeping import CREEP_RATE
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Quantity, Sheet
from workbook.book.sentence import amount, around
from workbook.drive.motor import continuous_at
from workbook.fields.units import PER_MINUTE, PERCENT, shown
from workbook.machines.machine.drive.max_rate import cubic, largest
from workbook.machines.machine.drive.view import DriveView

CELLS = cell_tables(__file__)

DECIMALS = 9  # of a use: limits that are used alike are told apart by no rounding
FALLEN = "SUMPRODUCT(MAX(([@pt.TC]^2)^0.5+@fall*(([@pt.n]^2)^0.5*@slow>@knee)*(([@pt.n]^2)^0.5*@slow-@knee)))"


def creeping_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the table of the torques while the drive creeps, and of their limits."""
    cell, checks = CELLS["creep"], view.creep_checks
    asked = FALLEN if view.knows_falling else largest("TC")
    parts = {"peak": asked, "behind": largest("SC"), "mean": cubic("[@pt.SC]")}
    each = formulas_by_row(__file__, "by limit", continuous=continuous_at("(@mean*@slow)"), **parts)
    size = max(view.scales.torque, view.scales.behind)
    CELLS["rate"].begin(sheet)
    sheet.rows(CELLS["rate"]("@creep_rate", shown(CREEP_RATE, PER_MINUTE)), CELLS["rate"]("@slow", view.slow))
    cell.place(
        sheet,
        cell("name", [check.name for check in checks]),
        cell("value", [check.value for check in checks], asked=each["asked"], scale=size),
        cell("limit", [0.0 if math.isinf(check.limit) else check.limit for check in checks], limit_of=each["limit"]),
        cell("use", uses(view), decimals=DECIMALS, scale=1.0),
    )
    sheet.row += 1
    most = uses(view).index(max(uses(view)))
    sheet.rows(CELLS["results"]("@creep_binds", view.creep_checks[most].name))


def uses(view: DriveView) -> list[float]:
    """Return the use of each limit."""
    return [round(check.use, DECIMALS) for check in view.creep_checks]


def largest_use(view: DriveView) -> Quantity:
    """Return the share that is used of the limit that is used most."""
    return CELLS["results"]("@creep_use", max(uses(view)), scale=1.0, limit=1.0)


def creeping_check(view: DriveView) -> Quantity:
    """Return the check that the drive holds its limits while it creeps."""
    most, forces = max(uses(view)), view.tables.machine.given.creep_forces
    worst = view.creep_checks[uses(view).index(most)].name
    says = around("@creep_binds", worst, "", " is ").then(
        amount("100*@creep_use", shown(most, PERCENT), "", " % of its limit, process forces ")
    )
    return CELLS["check"](
        "@ok_creep", most <= 1.0, called=view.driven.called, says=says.then(around("creep_forces", forces, "", ""))
    )
