"""The axes of a machine in short, for its first sheet: travel, greatest rates, and what each drive is used to."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from engine.drive.motor import Reserve
from workbook.book.declare import Quantity, Sheet, calc, result
from workbook.fields.units import PERCENT, RPM, shown
from workbook.machines.machine.drive.max_rate import RATE_LOOK
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.timing.sheet import units
from workbook.machines.machine.view import MachineView, MovingAxis

WHOLE = 100.0  # % of a limit
NO_DRIVE, ENTERED, MACHINES = "–", "as entered", "machine's"
NAMED = 'IF({0}motor_name="","' + ENTERED + '",{0}motor_name)'
PEAK = "MAX({0}tmax,0-{0}tmin)"


def axes_summary(sheet: Sheet, machine: MachineView, drives: Mapping[int, DriveView]) -> None:
    """Declare a row for each axis of the table ``axes``: its travel and rates, and its motor where there are drives."""
    axes, symbols = machine.axes, machine.over.symbols
    reaches = [[shown(end, axis.unit) for end in axis.motion.reach] for axis in axes]

    def each(formula: str) -> list[str]:
        return [formula.format(i) for i in range(1, len(axes) + 1)]

    sheet.row += 1
    sheet.table(
        "axes_short", "Axes", len(axes),
        calc("axis", "axis", "", "", each("=[axes.name.{0}]"), [axis.given.name for axis in axes], align="left"),
        result("travel", "travel", "h", units(machine), each("=[axes.high.{0}]-[axes.low.{0}]"),
               [high - low for low, high in reaches], "highest less lowest position"),
        result("v", "greatest velocity", symbols[1], units(machine, 1), each("=[axes.v.{0}]"),
               [axis.max_velocity for axis in axes]),
        result("a", "greatest acceleration", symbols[2], units(machine, 2), each("=[axes.a.{0}]"),
               [axis.max_acceleration for axis in axes]),
        *(motors(axes, drives) if drives else []),
    )  # fmt: skip


def motors(axes: Sequence[MovingAxis], drives: Mapping[int, DriveView]) -> list[Quantity]:
    """Return the columns on motors: torque and speed with the share of each limit that is used, the highest rate."""
    used = {number: view.reserve for number, view in drives.items()}

    def column(
        name: str, label: str, symbol: str, unit: str, formula: str, value: Callable[[DriveView, Reserve], Any],
        source: str = "", look: str = "", limit: float = 0.0,
    ) -> Quantity:  # fmt: skip
        numbers = [axis.number for axis in axes]
        texts = [f"={formula.format(f'drive{i}_')}" if i in drives else f'="{NO_DRIVE}"' for i in numbers]
        values = [value(drives[i], used[i]) if i in drives else NO_DRIVE for i in numbers]
        return result(name, label, symbol, unit, texts, values, source, format=look, align="right", limit=limit)

    return [
        column("motor", "motor", "", "", NAMED,
               lambda view, _: (view.driven.entered.motor and view.driven.entered.motor.name) or ENTERED),
        column("ratio", "ratio of the reducer", "i", "", "{0}i1", lambda view, _: view.driven.reducer.ratio),
        column("peak", "peak torque", "T_max", "Nm", PEAK, lambda _, use: use.peak_torque.value),
        column("of_peak", "of the motor's peak", "", "%", f"100*{PEAK}/{{0}}motor_peak",
               lambda _, use: shown(use.peak_torque.use, PERCENT), look="0", limit=WHOLE),
        column("rms", "RMS torque", "T_rms", "Nm", "{0}rms", lambda _, use: use.rms_torque.value),
        column("of_rated", "of its continuous torque", "", "%", "100*{0}rms/{0}continuous",
               lambda _, use: shown(use.rms_torque.use, PERCENT), look="0", limit=WHOLE),
        column("speed", "speed", "n_max", "rpm", "{0}speed", lambda _, use: shown(use.speed.value, RPM), look="0"),
        column("of_speed", "of the motor's largest", "", "%", "100*{0}speed/{0}motor_nmax",
               lambda _, use: shown(use.speed.use, PERCENT), look="0", limit=WHOLE),
        column("sized", "sized at", "N", "cycles/min", f'IF({{0}}own_rate="","{MACHINES}",{{0}}own_rate)',
               lambda view, _: MACHINES if view.driven.entered.rate is None else view.rate),
        column("lowest", "lowest rate", "N", "cycles/min", "{0}lowest", lambda view, _: view.rates.low,
               "within all limits; 0: standstill", RATE_LOOK),
        column("binds_low", "limiting factor", "", "", "{0}binds_low", lambda view, _: view.rates.low_limit),
        column("highest", "highest rate", "N", "cycles/min", "{0}highest", lambda view, _: view.rates.high,
               "within all limits", "0.0"),
        column("binds", "limiting factor", "", "", "{0}binds", lambda view, _: view.rates.high_limit),
    ]  # fmt: skip
