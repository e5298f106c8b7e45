"""The axes of a machine in short, for its first sheet: travel, greatest rates, and what each drive is used to."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from engine.drive.motor import Reserve
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import colour
from workbook.book.declare import Quantity, Sheet
from workbook.book.public_names import ENTERED
from workbook.book.sentence import Sentence, figure
from workbook.fields.units import PERCENT, shown
from workbook.machines.machine.drive.max_rate import RATE_LOOK
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.gap import ClearanceView
from workbook.machines.machine.timing.sheet import units
from workbook.machines.machine.view import MachineView, MovingAxis

CELLS = cell_tables(__file__)

WHOLE = 100.0  # % of a limit
NO_DRIVE = "–"
ON_A_PAGE = 8  # axes at most, of which all is printed on one page in letters that can be read


def axes_summary(sheet: Sheet, machine: MachineView, drives: Mapping[int, DriveView]) -> None:
    """Declare a row for each axis of the table ``axes``: its travel and rates, and its motor where there are drives."""
    axes, symbols = machine.axes, machine.over.symbols
    reaches = [[shown(end, axis.unit) for end in axis.motion.reach] for axis in axes]
    number = [axis.number for axis in axes]
    speed, acceleration = (units(machine, order) for order in (1, 2))
    of_motors = motors(axes, drives) if drives else []
    sheet.one_page = len(axes) <= ON_A_PAGE
    cell = CELLS["axes_short"].sharing(number=number)
    block = cell.place(
        sheet,
        cell("axis", [axis.given.name for axis in axes])._replace(inks=tuple(map(colour, number))),
        cell("group", [axis.given.group or "" for axis in axes]),
        *of_motors[:2],
        cell("travel", [high - low for low, high in reaches], unit=units(machine)),
        cell("v", [axis.max_velocity for axis in axes], symbol=symbols[1], unit=speed),
        cell("a", [axis.max_acceleration for axis in axes], symbol=symbols[2], unit=acceleration),
        *of_motors[2:-2],
    )
    if drives:
        sheet.workings(block, "axes_low", "", sheet.print_columns + 2, *of_motors[-2:])


def gaps_summary(sheet: Sheet, gaps: Sequence[ClearanceView]) -> None:
    """Declare the least gap of each clearance, and where it is."""
    if not gaps:
        return
    over, size, unit = gaps[0].over, max(gap.size for gap in gaps), ", ".join(dict.fromkeys(gap.unit for gap in gaps))
    cell = CELLS["gaps_short"].sharing(n=[gap.number for gap in gaps], unit=unit, over=over)
    cell.place(
        sheet,
        cell("name", [gap.given.name for gap in gaps]),
        cell("gap", [gap.least for gap in gaps], scale=size),
        cell("least", [gap.given.least for gap in gaps]),
        cell("at", [over.shown(gap.place) for gap in gaps], scale=over.length, format=over.format),
    )


def least_gap(gaps: Sequence[ClearanceView]) -> list[Quantity]:
    """Return the least of all gaps, if there are any of the same unit, and which it is."""
    if len({gap.unit for gap in gaps}) != 1:
        return []
    gap, row = min(gaps, key=lambda gap: gap.least), "MATCH(about_gap,[gaps_short.gap],0)"
    name = f"INDEX([gaps_short.name],{row})" if gaps[1:] else "[gaps_short.name.1]"
    cell = CELLS["least_gap"].sharing(unit=gap.unit, name=name)
    size = max(gap.size for gap in gaps)
    return [cell("about_gap", gap.least, scale=size), cell("about_gap_of", f"{gap.unit}, {gap.given.name}")]


def motors(axes: Sequence[MovingAxis], drives: Mapping[int, DriveView]) -> list[Quantity]:
    """Return the columns on motors: what each is and uses of each limit, the highest and then the lowest rate."""
    cell, numbers = CELLS["motors"], [axis.number for axis in axes]
    scopes = [f"drive{number}_" for number in numbers]
    reserves = {number: view.reserve for number, view in drives.items()}

    def column(name: str, value: Callable[[DriveView, Reserve], Any], **more: Any) -> Quantity:
        values = [value(drives[i], reserves[i]) if i in drives else NO_DRIVE for i in numbers]
        quantity = cell(name, values, drive=scopes, **more)
        formulas = zip(numbers, quantity.formula or (), strict=True)
        return quantity._replace(formula=[text if i in drives else f'="{NO_DRIVE}"' for i, text in formulas])

    def used(name: str, share: Callable[[DriveView, Reserve], float]) -> Quantity:
        return column(name, lambda view, reserve: shown(share(view, reserve), PERCENT), limit=WHOLE)

    return [
        column("motor", lambda view, _: view.driven.entered_motor.name or ENTERED, entered=ENTERED),
        column(
            "reducer",
            lambda view, _: (
                view.driven.entered.reducer.name or Sentence(f"i = {figure(round(view.driven.reducer.ratio, 3))}")
            ),
        ),
        used("of_rated", lambda _, reserve: reserve.rms_torque.use),
        used("of_peak", lambda _, reserve: reserve.peak_torque.use),
        used("of_speed", lambda _, reserve: reserve.speed.use),
        used("of_reducer", lambda view, _: max(check.use for check in view.reducer_checks[:2])),
        used("of_inertia", lambda view, _: view.inertia_ratio / view.driven.limits.inertia_ratio),
        column("sized", lambda view, _: view.rate),
        column("highest", lambda view, _: view.rates.high),
        column("binds", lambda view, _: view.rates.high_limit),
        column("lowest", lambda view, _: view.rates.low, format=RATE_LOOK),
        column("binds_low", lambda view, _: view.rates.low_limit),
    ]
